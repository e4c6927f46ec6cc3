// The joint verdict where the rasterizer computes window coordinates itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "legal/joint.h"

namespace rasterproof::legal {
namespace {

constexpr int kWidth = 128;
constexpr double kStep = 0x1p-8;

// Vertices as near to half a step beside a sample as float32 lets them: what they snap to depends
// on the last bits of the division.
struct NearATie {
  Scene scene;
  float w = 1;
  double window_x = 0;  ///< of the right side, without rounding
};

// Returns a scene whose right side lies `below` units of 2^-24 before the tie.
NearATie RandomScene(std::mt19937_64& random, double below) {
  NearATie near;
  near.w = std::uniform_real_distribution<float>(1, 2)(random);
  const double tie = std::uniform_int_distribution<int>(64, 127)(random) + 0.5 + kStep / 2;
  const auto x = static_cast<float>(tie * (1 - below * kTransformErrorUnit) * near.w);
  near.window_x = double{x} / near.w;
  near.scene.width = kWidth;
  near.scene.height = 2;
  near.scene.clip_space = true;
  const double w = near.w;
  near.scene.vertices = {{0, 0, 0, w}, {x, 0, 0, w}, {x, 2 * w, 0, w}};
  near.scene.triangles = {{0, 1, 2}};
  return near;
}

// A grid of 8 bits, nearest, with so much error of the transform.
Profile Stating(std::optional<double> transform_error) {
  Profile profile;
  profile.name = "transform";
  profile.snap = {8, SnapRule::kNearestEven};
  profile.freedom = {.snap_tolerance = 0.5, .transform_error = transform_error};
  return profile;
}

// What a rasterizer draws that puts the right side at x, before it snaps.
CoverageCounts DrawnWith(const NearATie& near, double x) {
  Scene window = near.scene;
  window.clip_space = false;
  window.precision = Precision::kFloat64;
  window.vertices = {{0, 0, 0, 1}, {x, 0, 0, 1}, {x, 2, 0, 1}};
  Profile snapping;
  snapping.snap = {8, SnapRule::kNearestEven};
  return exact::Coverage(window, snapping);
}

float ByReciprocal(const NearATie& near) {
  const float reciprocal = 1.0F / near.w;
  return static_cast<float>(near.scene.vertices[1].x) * reciprocal;
}

Legality Judge(const NearATie& near, const CoverageCounts& drawn, double transform_error) {
  Observed observed;
  observed.together = &drawn;
  return JudgeJointly(near.scene, {Stating(transform_error), near.scene}, observed).legality;
}

TEST(ClipSpace, AReciprocalIsLegalWithinTwoRoundingsAndNotWithoutAny) {
  std::mt19937_64 random(20261123);
  int moved = 0;
  for (int n = 0; n < 300; ++n) {
    const NearATie near = RandomScene(random, 0);
    const CoverageCounts drawn = DrawnWith(near, ByReciprocal(near));
    // Two roundings of 2^-24 each, and their product.
    EXPECT_EQ(Judge(near, drawn, 2.0001), Legality::kLegal) << n;
    if (Judge(near, drawn, 0) == Legality::kNotLegal) ++moved;
  }
  EXPECT_GT(moved, 30);
}

TEST(ClipSpace, OneUnitMoreThanStatedIsIllegal) {
  std::mt19937_64 random(7);
  for (int n = 0; n < 300; ++n) {
    const NearATie near = RandomScene(random, 6);
    // The tie is 5 to 7 units away: a rasterizer that errs by 8 is beyond it, one by 4 is not.
    const CoverageCounts far = DrawnWith(near, near.window_x * (1 + 8 * kTransformErrorUnit));
    const CoverageCounts close = DrawnWith(near, near.window_x * (1 + 4 * kTransformErrorUnit));
    EXPECT_EQ(Judge(near, far, 4), Legality::kNotLegal) << n;
    EXPECT_EQ(Judge(near, far, 8), Legality::kLegal) << n;
    EXPECT_EQ(Judge(near, close, 4), Legality::kLegal) << n;
  }
}

TEST(ClipSpace, WhereNoErrorIsStatedNothingIsJudged) {
  std::mt19937_64 random(11);
  const NearATie near = RandomScene(random, 0);
  const std::optional<std::string> why =
      WhyNotJoint(near.scene, {Stating(std::nullopt), near.scene});
  ASSERT_TRUE(why);
  EXPECT_EQ(*why, "the profile states no error of its transform");
  EXPECT_FALSE(WhyNotJoint(near.scene, {Stating(2), near.scene}));
  // 2^-24 of 128 pixels is 2^-9 of a step of the grid.
  EXPECT_FALSE(WhyNotJoint(near.scene, {Stating(0x1p9), near.scene}));
  EXPECT_TRUE(WhyNotJoint(near.scene, {Stating(0x1p13), near.scene}));
}

TEST(ClipSpace, NothingIsDecidedBeyondTheLimits) {
  std::mt19937_64 random(11);
  const NearATie near = RandomScene(random, 0);
  Profile profile = Stating(2);
  double farthest = 0;
  for (const Vertex& v : near.scene.vertices)
    farthest = std::max({farthest, v.x, v.y, v.x / v.w, v.y / v.w});
  profile.coordinate_limit = std::ceil(farthest);
  EXPECT_EQ(WhyNotJoint(near.scene, {profile, near.scene}), std::nullopt);
  Scene far = near.scene;
  far.vertices[1].w = far.vertices[1].x / (2 * profile.coordinate_limit);
  EXPECT_EQ(WhyNotJoint(far, {profile, far}),
            "a vertex projects beyond the profile's coordinate_limit");
  profile.max_target = {near.scene.width - 1, near.scene.height};
  EXPECT_EQ(WhyNotJoint(near.scene, {profile, near.scene}),
            "the target is larger than the profile's max_target");
}

TEST(ClipSpace, AWatertightProfileThatStatesItsFreedomIsJudgedJointly) {
  std::mt19937_64 random(13);
  const NearATie near = RandomScene(random, 0);
  Profile profile = Stating(2);
  profile.contract = Contract::kWatertight;
  EXPECT_FALSE(WhyNotJoint(near.scene, {profile, near.scene}));
  profile.freedom = {};
  EXPECT_TRUE(WhyNotJoint(near.scene, {profile, near.scene}));
}

}  // namespace
}  // namespace rasterproof::legal
