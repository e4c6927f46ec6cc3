#include "exact/snap_clip.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/profile_keys.h"
#include "core/snap.h"
#include "core/ulp.h"
#include "model/snap.h"
#include "tests/exact/families.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {
namespace {

mpz_class Floor(const mpq_class& q) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), q.get_num_mpz_t(), q.get_den_mpz_t());
  return whole;
}

// Steps of the grid, rounded by the rule's definition.
mpz_class NaiveSteps(const mpq_class& steps, SnapRule rule) {
  const mpq_class half(1, 2);
  const mpz_class below = Floor(steps);
  const mpz_class nearest = Floor(steps + half);  // half up
  const bool tie = steps - below == half;
  switch (rule) {
    case SnapRule::kNearestEven:
      return tie && mpz_odd_p(nearest.get_mpz_t()) != 0 ? below : nearest;
    case SnapRule::kNearestAway:
      return tie && steps < 0 ? below : nearest;
    case SnapRule::kHalfUp:
      return nearest;
    case SnapRule::kFloor:
      return below;
    case SnapRule::kTruncate:
      return steps < 0 && steps != below ? below + 1 : below;
  }
  return below;
}

TEST(SnapQuotient, RoundsTheRationalNotTheDouble) {
  Draw draw(61);
  int misled = 0;  // how often the rounded quotient would have snapped elsewhere
  for (int k = 0; k < 20000; ++k) {
    const Snap snap{draw.Below(kMaxSubpixelBits + 1), static_cast<SnapRule>(k % 5)};
    const double w = (1 + draw.Unit()) * std::ldexp(1.0, draw.Below(60) - 30);
    // An ulp or two about a multiple of half a step.
    const double place = std::ldexp(draw.Below(4000) - 2000, -1 - snap.bits);
    const double x = MoveByUlps(place * w, draw.Below(5) - 2);
    const mpq_class steps = mpq_class(x) / mpq_class(w) * (1 << snap.bits);
    const double truth = std::ldexp(NaiveSteps(steps, snap.rule).get_d(), -snap.bits);
    ASSERT_EQ(SnapQuotient(x, w, snap), truth) << x << " / " << w << " " << SnapRuleName(snap.rule);
    if (SnapCoordinate(x / w, snap) != truth) ++misled;
  }
  EXPECT_GT(misled, 500);
}

TEST(SnapQuotient, HoldsFarFromTies) {
  Draw draw(62);
  for (int k = 0; k < 5000; ++k) {
    const Snap snap{8, static_cast<SnapRule>(k % 5)};
    const double w = std::fabs(draw.Coordinate(static_cast<Family>(k % kFamilies)));
    const double x = draw.Coordinate(static_cast<Family>((k / 3) % kFamilies));
    if (w == 0 || !(std::fabs(x / w) < 0x1p42)) continue;
    const mpq_class steps = mpq_class(x) / mpq_class(w) * 256;
    ASSERT_EQ(SnapQuotient(x, w, snap), std::ldexp(NaiveSteps(steps, snap.rule).get_d(), -8));
  }
}

TEST(SnapClipScene, RefusesFormsThatSayNothingOfAQuotient) {
  Scene scene;
  scene.clip_space = true;
  scene.vertices = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  profile.snap = {8, SnapRule::kNearestEven};
  EXPECT_FALSE(SnapClipScene(scene, {profile, scene}).clip_space);
  for (const SnapForm form : {SnapForm::kFloat32Difference, SnapForm::kExactDifference}) {
    profile.snap.form = form;
    EXPECT_THROW(SnapClipScene(scene, {profile, scene}), InputError);
  }
}

TEST(SnapQuotient, RefusesWhatFitsNoGridPointOfADouble) {
  EXPECT_THROW(SnapQuotient(0x1p42, 1, {8, SnapRule::kFloor}), InputError);
  EXPECT_THROW(SnapQuotient(1e300, 1e-300, {8, SnapRule::kFloor}), InputError);
  EXPECT_EQ(SnapQuotient(-0x1.ffffp41, 1, {8, SnapRule::kFloor}), -0x1.ffffp41);
}

}  // namespace
}  // namespace rasterproof::exact
