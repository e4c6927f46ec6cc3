// What a legal set leaves open about facings is let pass, and an exchange by triangle, call or
// target is found.
#include "props/judging/freedom/facing_freedom.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "core/profile.h"
#include "core/vertex.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/trial.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::props {
namespace {

PropertyResult RunOn(const std::string& name, const Property& property, std::uint64_t seed) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
  return RunCampaign(*subject, property, {.seed = seed, .cases = 200, .shrink_budget = 20});
}

LegalTriangle InVulkan(const Scene& scene) {
  Case c;
  c.scene = scene;
  c.profile = *PresetProfile("vulkan");
  return LegalTriangle(PlacedCase(c), scene.triangles[0]);
}

Scene OnEight(Vertex a, Vertex b, Vertex c) {
  Scene scene;
  scene.width = scene.height = 8;
  scene.vertices = {a, b, c};
  scene.triangles = {{0, 1, 2}};
  return scene;
}

TEST(LegalTriangle, IsOpenWhereLegalPlacesOrClippingMayTurnIt) {
  const Vertex a{1, 1, 0, 1};
  const Vertex b{7, 1, 0, 1};
  EXPECT_NE(InVulkan(OnEight(a, b, {1, 7, 0, 1})).facing(), 0);
  EXPECT_EQ(InVulkan(OnEight(a, b, {1, 7, 0, 1})).facing(),
            -InVulkan(OnEight(b, a, {1, 7, 0, 1})).facing());
  // All on the grid of four bits, which moves none of them; with finer grids, none either.
  EXPECT_NE(InVulkan(OnEight(a, b, {4, 1.0625, 0, 1})).facing(), 0);
  // Off it by a hair: less than a step up or down.
  EXPECT_EQ(InVulkan(OnEight(a, b, {4, 1.03125, 0, 1})).facing(), 0);
  // Broad, but a sliver of it is inside the target.
  EXPECT_EQ(InVulkan(OnEight({7.9375, 0, 0, 1}, {20, 0, 0, 1}, {7.9375, 9, 0, 1})).facing(), 0);
  EXPECT_NE(InVulkan(OnEight({7, 0, 0, 1}, {20, 0, 0, 1}, {7, 9, 0, 1})).facing(), 0);
}

// The snap to eight bits turns it over, and it covers a sample: its side is the one after the snap
// where the law leaves no other place, and either where it does.
TEST(LegalTriangle, FacesAsItDoesAfterTheSnapWhereThatIsTheOnlyLegalPlace) {
  const Scene scene = OnEight({0x1.24b91p+2, 0x1.9427c2p-1}, {0x1.9332f2p+2, 0x1.0ea6e8p+1},
                              {0x1.7a5c98p+2, 0x1.d0a5c4p+0});
  EXPECT_EQ(InVulkan(scene).facing(), 0);
  Case c;
  c.scene = scene;
  c.profile = *PresetProfile("d3d11-canonical");
  EXPECT_EQ(LegalTriangle(PlacedCase(c), scene.triangles[0]).facing(), -1);
  for (const auto& [name, outcome] : {std::pair{"mutant:facing-of-input", Outcome::kViolated},
                                      std::pair{"mutant:flat-of-input", Outcome::kHolds}}) {
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
    c.profile = subject->Info().profile;
    const Property& property = *FindProperty("FacingIsOneAtAllSamples");
    EXPECT_EQ(TryCase(*subject, property, c).verdict.outcome, outcome) << name;
  }
}

// From x to the target's right edge, grown by a step, the strip is as thick as the limit of four
// steps and `more`: the margin for roundings is 2^-44 of 200.
TEST(LegalTriangle, IsFixedJustBeyondTheThinnestClippedPolygon) {
  const auto facing_of = [](double more) {
    const double x = 8.0625 - 0.25 - more;
    return InVulkan(OnEight({x, -100, 0, 1}, {200, -100, 0, 1}, {x, 100, 0, 1})).facing();
  };
  EXPECT_EQ(facing_of(0), 0);
  EXPECT_EQ(facing_of(0x1p-38), 0);
  EXPECT_NE(facing_of(0x1p-36), 0);
}

double DoubledArea(std::span<const Point2> polygon) {
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 a = polygon[k];
    const Point2 b = polygon[(k + 1) % polygon.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

constexpr double kStep = 0x1p-4;
constexpr double kLow = 4 + 0x1p-10;

// A broad triangle, of which a wedge crosses the target, so thick on its right side.
Scene Wedge(double thickness) {
  const double far = kLow + thickness * 1000.5 / 8.5;
  return OnEight({-0.5, kLow, 0, 1}, {1000, kLow, 0, 1}, {1000, far, 0, 1});
}

// Both its edges can move by a step, toward each other.
TEST(LegalTriangle, IsOpenWhereAClippedPolygonOfTwoToFourStepsMayHaveNoArea) {
  constexpr double kThickness = 3 * kStep - 0x1p-9;
  EXPECT_EQ(InVulkan(Wedge(kThickness)).facing(), 0);
  EXPECT_NE(InVulkan(Wedge(5 * kStep)).facing(), 0);
  const std::array<Point2, 4> clipped{
      {{0, kLow}, {8, kLow}, {8, kLow + kThickness}, {0, kLow + kThickness * 0.5 / 8.5}}};
  const std::array<Point2, 4> placed{{{0, 4 + kStep}, {8, 4 + kStep}, {8, 4 + 2 * kStep}, {0, 4}}};
  for (std::size_t k = 0; k < placed.size(); ++k) {
    EXPECT_LT(std::fabs(placed[k].y - clipped[k].y), kStep) << "a legal place of vertex " << k;
  }
  EXPECT_GT(DoubledArea(clipped), 0);
  EXPECT_EQ(DoubledArea(placed), 0);
}

TEST(LegalTriangle, CoversInEveryModelWhatNoStepUncovers) {
  const LegalTriangle triangle =
      InVulkan(OnEight({1.03, 1.03, 0, 1}, {7.03, 1.03, 0, 1}, {1.03, 7.03, 0, 1}));
  EXPECT_TRUE(triangle.CoversInEveryModel({2.5, 2.5}));
  EXPECT_FALSE(triangle.CoversInEveryModel({1.05, 2.5}));
  EXPECT_TRUE(triangle.MayCover({1.0, 2.5}));
  EXPECT_FALSE(triangle.MayCover({12.5, 2.5}));
}

TEST(Facings, OfLegalVariantsAreTaken) {
  for (const char* name : {"legal:vulkan-facing-exchanged", "legal:d3d11-facing-exchanged",
                           "legal:webgpu-facing-exchanged", "legal:vulkan-facing-4-bits",
                           "legal:vulkan-facing-clipped", "legal:d3d11-facing-clipped"}) {
    for (const Property* property :
         {FindProperty("FacingIsOneAtAllSamples"), FindProperty("CullingRemovesOneFacing")}) {
      const PropertyResult result = RunOn(name, *property, 1);
      EXPECT_EQ(result.outcome, Outcome::kHolds) << name << ": " << result.message;
      const bool exchanged = std::string(name).ends_with("exchanged");
      EXPECT_NE(result.message.find(exchanged ? "the side of negative area" : "of positive area"),
                std::string::npos)
          << name << ": " << result.message;
    }
  }
}

TEST(Facings, ExchangedByTriangleCallOrTargetAreFound) {
  for (const char* name : {"mutant:vulkan-facing-by-hash", "mutant:d3d11-facing-by-hash",
                           "mutant:vulkan-facing-by-place", "mutant:vulkan-facing-by-call",
                           "mutant:vulkan-facing-by-target"}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      EXPECT_EQ(RunOn(name, *FindProperty("FacingIsOneAtAllSamples"), seed).outcome,
                Outcome::kViolated)
          << name;
    }
  }
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_EQ(RunOn("mutant:vulkan-culls-the-other", *FindProperty("CullingRemovesOneFacing"), seed)
                  .outcome,
              Outcome::kViolated);
  }
}

}  // namespace
}  // namespace rasterproof::props
