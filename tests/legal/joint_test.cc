// The joint verdict against a search through all legal models, one after the other.
#include "legal/joint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "legal/decided.h"
#include "tests/legal/all_models.h"

namespace rasterproof::legal {
namespace {

using testing::AsCounts;
using testing::Drawn;
using testing::Draws;
using testing::ExplainsAlone;
using testing::ExplainsCounts;
using testing::IsJudgedAlike;
using testing::IsLegalBySearch;
using testing::kSide;
using testing::Model;

TEST(JointVerdict, EqualsASearchThroughAllModelsForTrianglesDrawnAlone) {
  Draws draws(20261123);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene, profile)) continue;
    Drawn drawn = draws.ALegalDrawing(scene, profile);
    if (n % 2 == 0) {
      const std::size_t t = draws.Below(drawn.size());
      const std::size_t s = draws.Below(kSide * kSide);
      drawn[t][s] = !drawn[t][s];
    }
    const std::vector<CoverageCounts> counts = AsCounts(drawn);
    Observed observed;
    for (const CoverageCounts& one : counts) observed.alone.push_back(&one);
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          return ExplainsAlone(scene, profile, rule, model, drawn);
        });
    const JointVerdict verdict = JudgeJointly(scene, {profile, scene}, observed);
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ASSERT_EQ(verdict.core.has_value(), !is_legal) << n;
    ++(is_legal ? legal : illegal);
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 60);
}

TEST(JointVerdict, EqualsASearchThroughAllModelsForCounts) {
  Draws draws(7);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene, profile)) continue;
    CoverageCounts sum(kSide, kSide);
    for (const CoverageCounts& one : AsCounts(draws.ALegalDrawing(scene, profile))) sum += one;
    if (n % 2 == 0) {
      std::uint32_t& count = sum.front[draws.Below(kSide * kSide)];
      count = count == 0 || draws.Below(2) == 0 ? count + 1 : count - 1;
    }
    Observed observed;
    observed.together = &sum;
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          return ExplainsCounts(scene, profile, rule, model, sum);
        });
    const JointVerdict verdict = JudgeJointly(scene, {profile, scene}, observed);
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ++(is_legal ? legal : illegal);
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 60);
}

// Two edges pass closely by the samples (2.5, 4.5) and (3.5, 3.5) to a vertex beside
// (17/6, 41/6), a grid point of `bits` bits: none of the grid points of 4 to 16 bits around it
// leaves both samples on their sides. A third lies beside (0.5, 6.5) and covers it once its ends
// are rounded down, which no grid of 24 bits does, nor none.
Scene PinnedScene(int bits) {
  const double to_right = bits % 2;
  const double up = bits == 17 ? 2 : 3;
  const double x = std::ldexp(std::floor(std::ldexp(17.0 / 6, bits)) + to_right, -bits);
  const double y = std::ldexp(std::floor(std::ldexp(41.0 / 6, bits)) - up, -bits);
  Scene scene;
  scene.width = 8;
  scene.height = 8;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{2, 1, 0, 1},
                    {x, y, 0, 1},
                    {8, 4, 0, 1},
                    {4, 1, 0, 1},
                    {7, 3, 0, 1},
                    {0.5 + 0x1p-24, 5, 0, 1},
                    {0.5 + 0x1p-24, 8, 0, 1},
                    {2, 6.5, 0, 1}};
  scene.triangles = {{0, 1, 2}, {3, 1, 4}, {5, 6, 7}};
  return scene;
}

Legality OfVulkan(const Scene& scene, const Scene& drawn) {
  const CoverageCounts counts = exact::Coverage(drawn, *PresetProfile("real"));
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(scene, {*PresetProfile("vulkan"), scene}, observed).legality;
}

TEST(JointVerdict, GridsOfMoreThanSixteenBitsAreLegal) {
  for (int bits = 17; bits <= 23; ++bits) {
    const Scene scene = PinnedScene(bits);
    Scene drawn = scene;
    for (Vertex& v : drawn.vertices) {
      v.x = std::ldexp(std::floor(std::ldexp(v.x, bits)), -bits);
      v.y = std::ldexp(std::floor(std::ldexp(v.y, bits)), -bits);
    }
    EXPECT_EQ(OfVulkan(scene, drawn), Legality::kLegal) << bits;
    drawn.vertices[1].x += 1;  // beyond every legal place
    EXPECT_EQ(OfVulkan(scene, drawn), Legality::kNotLegal) << bits;
  }
}

TEST(JointVerdict, NothingIsSaidOfAMapOrOfSamplesThatLieAnywhere) {
  const Scene scene = PinnedScene(19);
  Profile profile = *PresetProfile("vulkan");
  EXPECT_FALSE(WhyNotJoint(scene, {profile, scene}).has_value());
  profile.transform = Transform{};
  profile.transform->map = MapGrid{};
  EXPECT_TRUE(WhyNotJoint(scene, {profile, scene}).has_value()) << "window space is not the map's";
  profile = *PresetProfile("vulkan-4x");
  EXPECT_TRUE(WhyNotJoint(scene, {profile, scene}).has_value());
  Profile clips;
  clips.guard_band = AroundTarget{0};
  Scene leaves = scene;
  EXPECT_FALSE(WhyNotJoint(leaves, {clips, leaves}).has_value());
  leaves.vertices[0].x = -1;
  EXPECT_TRUE(WhyNotJoint(leaves, {clips, leaves}).has_value()) << "its edges may move anyhow";
}

TEST(JointVerdict, NothingIsSaidBeyondTheCoordinateLimit) {
  Scene scene = PinnedScene(19);
  scene.vertices[2].x = 32768.5;
  EXPECT_TRUE(WhyNotJoint(scene, {*PresetProfile("vulkan"), scene}).has_value());
  scene.vertices[2].x = 32768;
  EXPECT_FALSE(WhyNotJoint(scene, {*PresetProfile("vulkan"), scene}).has_value());
}

// A rasterizer that places vertices again for each column of samples, legally every time.
TEST(JointVerdict, ConvictsWhatEverySampleByItselfAcquits) {
  Draws draws(20261123);
  int convicted = 0;
  for (int n = 0; n < 3000; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene, profile)) continue;
    CoverageCounts mixed = draws.AMixture(scene, profile);
    const Decided decided = DecidedSamples(scene, {profile, scene});
    for (std::size_t s = 0; s < decided.counts.size(); ++s) {
      ASSERT_NE(decided.counts[s] >> mixed.front[s] & 1U, 0U) << n << ", sample " << s;
    }
    Observed observed;
    observed.together = &mixed;
    convicted +=
        JudgeJointly(scene, {profile, scene}, observed).legality == Legality::kNotLegal ? 1 : 0;
  }
  EXPECT_GT(convicted, 20);
}

}  // namespace
}  // namespace rasterproof::legal
