// What legal models agree on, against a search through all of them.
#include "legal/decided.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "tests/legal/all_models.h"
#include "tests/share.h"

namespace rasterproof::legal {
namespace {

using testing::Draws;
using testing::ExplainsCountAt;
using testing::IsJudgedAlike;
using testing::IsLegalBySearch;
using testing::Model;

// Which counts some model of some owners has at the sample, a bit each.
std::uint64_t CountsBySearch(const Scene& scene, const Profile& profile, std::size_t s) {
  std::uint64_t counts = 0;
  for (std::uint32_t n = 0; n <= scene.triangles.size(); ++n) {
    // Other samples are open: their places and owners are independent of these.
    const auto explains = [&](const TieRule& rule, const Model& model) {
      return ExplainsCountAt(scene, profile, rule, model, s, n);
    };
    if (IsLegalBySearch(scene, profile, explains)) counts |= std::uint64_t{1} << n;
  }
  return counts;
}

// What a triangle must and may cover is what counts of it alone say.
void ExpectAsIfAlone(const Decided& decided, const Scene& scene, const Profile& profile) {
  std::size_t open = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    Scene alone = scene;
    alone.triangles = {scene.triangles[t]};
    const Decided counts = DecidedSamples(alone, {profile, alone});
    TriangleDecided expected;
    for (std::size_t s = 0; s < counts.counts.size(); ++s) {
      if (counts.Least(s) > 0) expected.must.push_back(s);
      if (!counts.IsDecided(s)) expected.may.push_back(s);
    }
    EXPECT_EQ(decided.triangles[t].must, expected.must);
    EXPECT_EQ(decided.triangles[t].may, expected.may);
    open += expected.may.size();
  }
  EXPECT_EQ(decided.open.size(), open);
}

TEST(DecidedSamples, OfTwoGridsOnlyOneOfWhichCoversASampleItIsOpen) {
  // The common edge goes to 0.5, where the right one has the sample; from two bits on beyond it.
  Scene scene;
  scene.width = 2;
  scene.height = 1;
  scene.vertices = {{0.7, -3, 0, 1}, {4, -3, 0, 1}, {0.7, 4, 0, 1}, {-4, -3, 0, 1}};
  scene.triangles = {{0, 1, 2}, {3, 0, 2}};
  Profile profile;
  profile.snap.bits = 1;
  profile.freedom.least_bits = 1;
  const Decided decided = DecidedSamples(scene, {profile, scene});
  ASSERT_EQ(decided.open.size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_TRUE(std::ranges::find(decided.triangles[t].must, 0U) ==
                decided.triangles[t].must.end());
    EXPECT_EQ(decided.triangles[t].may, std::vector<std::size_t>{0});
    EXPECT_EQ(decided.open[t].triangle, t);
    EXPECT_EQ(decided.open[t].sample, 0U);
  }
  EXPECT_EQ(decided.Least(0), 1);  // whichever of the two it is
  EXPECT_EQ(decided.Most(0), 1);
}

TEST(DecidedSamples, AreTheCountsOfASearchThroughAllModels) {
  Draws draws(11);
  int decided = 0;
  int open = 0;
  for (int n = 0; n < Cases(260); ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const Decided samples = DecidedSamples(scene, {profile, scene});
    EXPECT_EQ(samples.bounded, 0U);
    ExpectAsIfAlone(samples, scene, profile);
    for (std::size_t s = 0; s < samples.counts.size(); ++s) {
      ASSERT_EQ(samples.counts[s], CountsBySearch(scene, profile, s)) << n << ", sample " << s;
      ++(samples.IsDecided(s) ? decided : open);
    }
  }
  EXPECT_GT(decided, Cases(300));
  EXPECT_GT(open, Cases(300));
}

}  // namespace
}  // namespace rasterproof::legal
