// The joint verdict against a search through all legal models, one after the other.
#include "legal/joint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "legal/decided.h"
#include "tests/legal/all_models.h"
#include "tests/share.h"

namespace rasterproof::legal {
namespace {

using testing::AsCounts;
using testing::Drawn;
using testing::Draws;
using testing::ExplainsAlone;
using testing::ExplainsCounts;
using testing::ExplainsSetAt;
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
    if (!IsJudgedAlike(scene)) continue;
    Drawn drawn = draws.ALegalDrawing(scene, profile);
    if (n % 2 == 0) {
      const std::size_t t = draws.Below(drawn.size());
      const std::size_t s = draws.Below(kSide * kSide);
      drawn[t][s] = !drawn[t][s];
    }
    const std::vector<CoverageCounts> counts = AsCounts(scene, drawn);
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
    if (!IsJudgedAlike(scene)) continue;
    CoverageCounts sum(kSide, kSide);
    for (const CoverageCounts& one : AsCounts(scene, draws.ALegalDrawing(scene, profile)))
      sum += one;
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

// Any triangle that covers a sample may be the one that is seen there, as after a depth test.
TEST(JointVerdict, EqualsASearchThroughAllModelsForIdsInNoOrder) {
  Draws draws(11);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const Drawn drawn = draws.ALegalDrawing(scene, profile);
    std::vector<std::int32_t> ids(kSide * kSide, kNoPrimitive);
    for (std::size_t s = 0; s < ids.size(); ++s) {
      const std::size_t first = draws.Below(drawn.size());
      for (std::size_t k = 0; k < drawn.size(); ++k) {
        const std::size_t t = (first + k) % drawn.size();
        if (drawn[t][s]) ids[s] = static_cast<std::int32_t>(t);
      }
    }
    if (n % 2 == 0) {
      ids[draws.Below(ids.size())] =
          static_cast<std::int32_t>(draws.Below(drawn.size() + 1)) + kNoPrimitive;
    }
    Observed observed;
    observed.primitive_ids = &ids;
    observed.any_is_visible = true;
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          for (std::size_t s = 0; s < ids.size(); ++s) {
            const auto accepts = [&](unsigned bits) {
              return ids[s] == kNoPrimitive ? bits == 0 : (bits >> ids[s] & 1U) != 0;
            };
            if (!ExplainsSetAt(scene, profile, rule, model, s, accepts)) return false;
          }
          return true;
        });
    const JointVerdict verdict = JudgeJointly(scene, {profile, scene}, observed);
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ++(is_legal ? legal : illegal);
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 60);
}

// The counts of triangles drawn alone, each on the side that it has in all legal models.
CoverageCounts OnTheirSides(const Drawn& drawn, const Decided& decided) {
  CoverageCounts counts(kSide, kSide);
  for (std::size_t t = 0; t < drawn.size(); ++t) {
    for (std::size_t s = 0; s < counts.size(); ++s)
      (decided.triangles[t].facing > 0 ? counts.front : counts.back)[s] += drawn[t][s] ? 1 : 0;
  }
  return counts;
}

TEST(JointVerdict, SidesOfALegalDrawingAreLegalAndOneTurnedIsNot) {
  Draws draws(12);
  int turned = 0;
  for (int n = 0; n < Cases(600); ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const Decided decided = DecidedSamples(scene, {profile, scene});
    const auto is_open = [](const TriangleDecided& one) { return one.facing == 0; };
    if (std::ranges::any_of(decided.triangles, is_open)) continue;
    CoverageCounts counts = OnTheirSides(draws.ALegalDrawing(scene, profile), decided);
    Observed observed;
    observed.together = &counts;
    observed.sides = Sides::kPositiveArea;
    const TargetProfile target(profile, scene);
    ASSERT_EQ(JudgeJointly(scene, target, observed).legality, Legality::kLegal) << n;
    std::swap(counts.front, counts.back);
    observed.sides = Sides::kNegativeArea;
    ASSERT_EQ(JudgeJointly(scene, target, observed).legality, Legality::kLegal) << n;
    const auto says_nothing = [&](std::size_t s) {
      return counts.front[s] == counts.back[s] ||
             std::ranges::any_of(decided.triangles, [&](const TriangleDecided& one) {
               return std::ranges::binary_search(one.may, s);
             });
    };
    std::size_t s = 0;
    while (s < counts.size() && says_nothing(s)) ++s;
    if (s == counts.size()) continue;
    std::swap(counts.front[s], counts.back[s]);
    const JointVerdict verdict = JudgeJointly(scene, target, observed);
    ASSERT_EQ(verdict.legality, Legality::kNotLegal) << n;
    EXPECT_TRUE(verdict.core->requirements.front().by_side.has_value());
    observed.sides = Sides::kNotCompared;
    ASSERT_EQ(JudgeJointly(scene, target, observed).legality, Legality::kLegal) << n;
    ++turned;
  }
  EXPECT_GE(turned, Cases(10));
}

// Legal places of its vertex turn this triangle over; the other leaves the target.
TEST(JointVerdict, ATriangleThatMayBeTurnedOverHasEitherSide) {
  Scene scene;
  scene.width = 3;
  scene.height = 3;
  scene.vertices = {{0, 0.5, 0, 1}, {3, 0.5, 0, 1}, {1.5, 0.5 + 0x1p-10, 0, 1},
                    {0, 1, 0, 1},   {9, 1, 0, 1},   {0, 9, 0, 1}};
  scene.precision = Precision::kFloat64;
  const TargetProfile profile(*PresetProfile("vulkan"), scene);
  for (const Triangle& triangle : {Triangle{0, 1, 2}, Triangle{3, 4, 5}}) {
    scene.triangles = {triangle};
    CoverageCounts counts = exact::Coverage(scene, *PresetProfile("real"));
    for (int side = 0; side < 2; ++side) {
      Observed observed;
      observed.together = &counts;
      observed.sides = Sides::kPositiveArea;
      EXPECT_EQ(JudgeJointly(scene, profile, observed).legality, Legality::kLegal) << triangle[0];
      std::swap(counts.front, counts.back);
    }
  }
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
  for (int n = 0; n < Cases(3000); ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
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
  EXPECT_GT(convicted, Cases(20));
}

}  // namespace
}  // namespace rasterproof::legal
