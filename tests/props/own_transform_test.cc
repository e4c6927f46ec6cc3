#include "props/run/own_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/transform.h"
#include "exact/coverage.h"
#include "gtest/gtest.h"
#include "model/transform.h"
#include "props/infer/infer.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

PropertyResult Campaign(const std::string& subject, const char* property, std::uint64_t cases) {
  const std::unique_ptr<Subject> made = subjects::MakeMutant(subject);
  CampaignOptions options;
  options.cases = cases;
  return RunCampaign(*made, *FindProperty(property), options);
}

TEST(OwnTransform, IsJudgedByItsOperations) {
  for (const char* const variant : {"quotients", "multiply-add", "fused", "add-multiply"}) {
    const auto result =
        Campaign("legal:transform-" + std::string(variant), "CoverageEqualsTheModel", 400);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << variant << ": " << result.message;
    EXPECT_GT(result.NearEdge().on_edge, 0U) << variant;
  }
}

TEST(OwnTransform, AnotherRoundingIsFoundAndShrunk) {
  const auto result = Campaign("mutant:transform-reciprocal", "CoverageEqualsTheModel", 1000);
  ASSERT_EQ(result.outcome, Outcome::kViolated);
  const Scene& scene = result.counterexample->value.scene;
  EXPECT_TRUE(scene.clip_space);
  EXPECT_EQ(scene.triangles.size(), 1U);
}

TEST(OwnTransform, PropertiesThatMoveVerticesDoNotApply) {
  const auto result =
      Campaign("legal:transform-multiply-add", "IntegerTranslationMovesCoverage", 20);
  EXPECT_NE(result.outcome, Outcome::kViolated) << result.message;
}

TEST(OwnTransform, OfAMapIsJudgedByItsOperations) {
  for (const char* const variant : {"quotient", "reciprocal", "quarter"}) {
    for (const char* const property : {"CoverageEqualsTheModel", "TilesDrawnApartEqualTheWhole"}) {
      const auto result = Campaign("legal:map-" + std::string(variant), property, 400);
      EXPECT_EQ(result.outcome, Outcome::kHolds) << variant << ": " << result.message;
      EXPECT_GT(result.exercised, 0U) << variant;
    }
  }
}

TEST(OwnTransform, TilesOfAMapThatPlaceFromTheirOwnOriginAreFound) {
  for (const char* const bug : {"origin", "origin-reciprocal", "origin-summed"}) {
    const auto result =
        Campaign("mutant:map-tile-" + std::string(bug), "TilesDrawnApartEqualTheWhole", 4000);
    ASSERT_EQ(result.outcome, Outcome::kViolated) << bug;
    EXPECT_FALSE(result.counterexample->value.scene.clip_space);
  }
}

TEST(OwnTransform, OtherOperationsOnAMapAreFound) {
  for (const char* const bug : {"reciprocal", "scaled-first", "in-float32"}) {
    const auto result = Campaign("mutant:map-" + std::string(bug), "CoverageEqualsTheModel", 4000);
    EXPECT_EQ(result.outcome, Outcome::kViolated) << bug;
  }
}

// Recipes aim at places; after a map vertices lie there, or a step of the map's coordinates beside.
TEST(OwnTransform, CasesOfAMapHaveItsSizeAndLieWhereRecipesAim) {
  const SubjectInfo info = subjects::MakeMutant("legal:map-quarter")->Info();
  int exact = 0;
  int beside = 0;
  int vertices = 0;
  for (std::uint64_t index = 0; index < 200; ++index) {
    PhiloxSource bits(1, index);
    const Case window = FindDomain("vertices-on-samples")->draw(bits, AsSeenByRecipes(info));
    const Case map = PutBehindTransform(window, info, bits);
    const Case seen = SeenCase(map);
    for (std::size_t k = 0; k < window.scene.vertices.size(); ++k) {
      const Vertex& aimed = window.scene.vertices[k];
      const Vertex& v = seen.scene.vertices[k];
      if (!(std::fabs(aimed.x) < 1024 && std::fabs(aimed.y) < 1024)) continue;
      ++vertices;
      EXPECT_NEAR(map.scene.vertices[k].x, 872512, 256);
      EXPECT_NEAR(map.scene.vertices[k].y, 6114970, 256);
      const double off = std::max(std::fabs(v.x - aimed.x), std::fabs(v.y - aimed.y));
      EXPECT_LT(off, 0x1p-27);
      ++(off == 0 ? exact : beside);
    }
  }
  EXPECT_GT(3 * exact, vertices);
  EXPECT_GT(5 * beside, vertices);
}

// What shares a place in the window shares it in clip space, or meshes would come apart.
TEST(OwnTransform, VerticesOfOnePlaceStayTogether) {
  const SubjectInfo info = subjects::MakeMutant("legal:transform-add-multiply")->Info();
  int shared = 0;
  for (std::uint64_t index = 0; index < 50; ++index) {
    PhiloxSource bits(1, index);
    const Case window = FindDomain("fans")->draw(bits, AsSeenByRecipes(info));
    const Case clip = PutBehindTransform(window, info, bits);
    ASSERT_EQ(clip.scene.vertices.size(), window.scene.vertices.size());
    std::map<std::array<double, 2>, Vertex> clip_of;
    for (std::size_t k = 0; k < window.scene.vertices.size(); ++k) {
      const Vertex& v = window.scene.vertices[k];
      const auto [found, is_new] = clip_of.try_emplace({v.x, v.y}, clip.scene.vertices[k]);
      EXPECT_EQ(found->second.x, clip.scene.vertices[k].x);
      EXPECT_EQ(found->second.w, clip.scene.vertices[k].w);
      if (!is_new) ++shared;
    }
  }
  EXPECT_GT(shared, 0);
}

// Told how the subject maps pixels to clip space, infer finds the model behind its viewport.
TEST(OwnTransform, IsLookedThroughByInfer) {
  for (const std::string_view name : {"legal:transform-multiply-add", "legal:transform-fused"}) {
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
    const Inference inference = Infer(*subject, {.checks = 60});
    EXPECT_TRUE(inference.Agrees()) << name << ": " << inference.message;
    EXPECT_FALSE(inference.remaining.empty()) << name;
  }
  // The same viewport behind which another snap was planted.
  Profile planted;
  planted.snap = {4, SnapRule::kHalfUp};
  SubjectInfo info = testing::SnappedInfo(8);
  info.takes_window = false;
  info.takes_clip = true;
  info.input = Precision::kFloat32;
  info.profile.transform = {.viewport = ViewportForm::kMultiplyAdd, .flips_y = true};
  FakeSubject subject(info,
                      [&](const Scene& clip, const DrawOptions& options, CoverageCounts& counts) {
                        Scene window = ToWindow(clip, *info.profile.transform);
                        counts += exact::Coverage(window, planted, options);
                      });
  const Inference found = Infer(subject, {.checks = 60});
  ASSERT_TRUE(found.Fits()) << found.message;
  EXPECT_EQ(found.remaining.front().snap, planted.snap);
}

}  // namespace
}  // namespace rasterproof::props
