// The places that are left to a sample: none is lost that explains what was drawn, and none is left
// where nothing does.
#include "props/judging/freedom/sample_region.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/placed_case.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr int kSide = 8;

PlacedCase CaseOf(std::vector<Vertex> vertices) {
  Case c;
  c.profile = *PresetProfile("vulkan-4x");
  c.scene.width = c.scene.height = kSide;
  c.scene.vertices = std::move(vertices);
  c.scene.triangles = {{0, 1, 2}};
  return PlacedCase(c);
}

TriangleReach ReachOf(const PlacedCase& c) { return *ReachOfTriangle(c, c.scene.triangles[0]); }

// Halves of a pixel on whole coordinates leave a point, a line, or nothing.
TEST(SampleRegion, IsEmptyOnlyBeyondTheCommonPoint) {
  const PixelSquare square{{2, 2}};
  const auto left = ReachOf(CaseOf({{0, 0}, {0, 8}, {2.5, 2.5}}));   // up to x = 2.5 at y = 2.5
  const auto right = ReachOf(CaseOf({{2.5, 2.5}, {8, 8}, {8, 0}}));  // from there
  SampleRegion touching;
  touching.KeepWithin(square, {&left.most, 1});
  touching.KeepWithin(square, {&right.most, 1});
  EXPECT_FALSE(touching.IsEmpty());
  const auto beyond = ReachOf(CaseOf({{2.5625, 2.5}, {8, 8}, {8, 0}}));  // a sixteenth further
  SampleRegion apart;
  apart.KeepWithin(square, {&left.most, 1});
  apart.KeepWithin(square, {&beyond.most, 1});
  EXPECT_TRUE(apart.IsEmpty());
}

// On its open interior a triangle takes all; its edges may be another's.
TEST(SampleRegion, KeepsTheEdgesOfWhatIsTakenAway) {
  const PixelSquare square{{2, 2}};
  SampleRegion edge;
  edge.TakeAway(square, *ReachOf(CaseOf({{0, 0}, {0, 8}, {8, 8}})).least);
  edge.TakeAway(square, *ReachOf(CaseOf({{0, 0}, {8, 8}, {8, 0}})).least);
  EXPECT_FALSE(edge.IsEmpty());  // the diagonal
  SampleRegion none;
  none.TakeAway(square, *ReachOf(CaseOf({{0, 0}, {0, 8}, {8, 0}})).least);
  EXPECT_TRUE(none.IsEmpty());
}

std::vector<Vertex> RandomTriangle(std::mt19937_64& random) {
  // On sixteenths, between them, and beyond the target, where it may be clipped.
  const bool on_grid = random() % 2 == 0;
  const bool is_wide = random() % 4 == 0;
  std::vector<Vertex> vertices;
  for (int k = 0; k < 3; ++k) {
    const auto coordinate = [&] {
      const double x = static_cast<double>(random() % 8193) / 1024;
      const double wide = is_wide ? 3 * x - kSide : x;
      return on_grid ? static_cast<double>(static_cast<int>(wide * 16)) / 16 : wide;
    };
    const double x = coordinate();
    const double y = coordinate();
    vertices.push_back({x, y});
  }
  return vertices;
}

// A model of the set, with its samples at random places on 1/256 of the closed pixel, drawn by
// the oracle: each of its own observations leaves a place.
TEST(SampleRegion, IsNeverEmptyForALegalModel) {
  std::mt19937_64 random(7);
  for (int run = 0; run < Cases(300); ++run) {
    Profile model = *PresetProfile("vulkan-4x");
    model.sample_positions = SamplePositions::kStated;
    model.pattern.locations = {
        {static_cast<double>(random() % 256) / 256, static_cast<double>(random() % 256) / 256}};
    model.snap.bits = static_cast<int>(4 + random() % 5);
    std::array<SampleRegion, kSide * kSide> regions;
    for (int t = 0; t < 12; ++t) {
      const PlacedCase c = CaseOf(RandomTriangle(random));
      const auto reach = ReachOfTriangle(c, c.scene.triangles[0]);
      if (!reach) continue;
      const CoverageCounts counts = exact::Coverage(c.scene, model);
      for (int k = 0; k < kSide * kSide; ++k) {
        const PixelSquare square = SquareOf(c, k % kSide, k / kSide);
        SampleRegion& region = regions[static_cast<std::size_t>(k)];
        if (counts.Count(static_cast<std::size_t>(k)) != 0) {
          ASSERT_FALSE(AreApart(square, reach->most)) << run << ' ' << t << ' ' << k;
          region.KeepWithin(square, {&reach->most, 1});
        } else if (reach->least) {
          ASSERT_FALSE(IsInside(square, *reach->least)) << run << ' ' << t << ' ' << k;
          region.TakeAway(square, *reach->least);
        }
        ASSERT_FALSE(region.IsEmpty()) << run << ' ' << t << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
