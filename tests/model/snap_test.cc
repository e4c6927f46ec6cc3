#include "model/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/snap.h"

namespace rasterproof {
namespace {

constexpr double kHalfStep = 0x1p-9;  // one half of 1/256

double Snapped(double x, SnapRule rule) { return SnapCoordinate(x, {8, rule}); }

TEST(SnapTest, TiesGoWhereTheRuleSays) {
  EXPECT_EQ(Snapped(1 + kHalfStep, SnapRule::kNearestEven), 1);
  EXPECT_EQ(Snapped(1 + 3 * kHalfStep, SnapRule::kNearestEven), 1 + 4 * kHalfStep);
  EXPECT_EQ(Snapped(1 + kHalfStep, SnapRule::kNearestAway), 1 + 2 * kHalfStep);
  EXPECT_EQ(Snapped(-1 - kHalfStep, SnapRule::kNearestAway), -1 - 2 * kHalfStep);
  EXPECT_EQ(Snapped(-1 - kHalfStep, SnapRule::kHalfUp), -1);
  EXPECT_EQ(Snapped(-1 - kHalfStep, SnapRule::kFloor), -1 - 2 * kHalfStep);
  EXPECT_EQ(Snapped(-1 - kHalfStep, SnapRule::kTruncate), -1);
}

// The values at which adding one half in float and truncating, as a well-known reference does, is
// wrong.
TEST(SnapTest, NoDoubleRoundingNearTies) {
  EXPECT_EQ(Snapped(0x1.fffffep-10, SnapRule::kNearestEven), 0);
  EXPECT_EQ(Snapped(0x1.fffffep-10, SnapRule::kHalfUp), 0);
  EXPECT_EQ(Snapped(65535.99609375, SnapRule::kNearestEven), 65535.99609375);
  // v - floor(v) of this one rounds to exactly one half.
  EXPECT_EQ(Snapped(-0x1.fffffffffffffp-10, SnapRule::kNearestAway), 0);
}

TEST(SnapTest, TinyValuesBecomePositiveZeroOrOneStep) {
  const double tiny = -std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(Snapped(tiny, SnapRule::kNearestEven), 0);
  EXPECT_FALSE(std::signbit(Snapped(tiny, SnapRule::kNearestEven)));
  EXPECT_FALSE(std::signbit(Snapped(-0.0, SnapRule::kNearestEven)));
  EXPECT_EQ(Snapped(tiny, SnapRule::kFloor), -2 * kHalfStep);
  EXPECT_EQ(Snapped(tiny, SnapRule::kTruncate), 0);
}

TEST(SnapTest, HugeAndNonFiniteValuesAreLeftAlone) {
  EXPECT_EQ(Snapped(1e30, SnapRule::kFloor), 1e30);
  EXPECT_EQ(Snapped(std::numeric_limits<double>::max(), SnapRule::kNearestEven),
            std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(Snapped(std::nan(""), SnapRule::kNearestEven)));
  EXPECT_TRUE(std::isinf(Snapped(-HUGE_VAL, SnapRule::kNearestEven)));
}

TEST(SnapTest, NoGridMeansNoChange) { EXPECT_EQ(SnapCoordinate(0.1, Snap{}), 0.1); }

double Difference(double x, SnapRule rule, SnapForm form) {
  return SnapCoordinate(x, {8, rule, form, 0.5});
}

TEST(SnapTest, ADifferenceIsRoundedAboutItsOrigin) {
  // 0.25 lies left of the origin: truncating goes right, and ties away from zero go left.
  EXPECT_EQ(Difference(0.25 + kHalfStep, SnapRule::kTruncate, SnapForm::kExactDifference),
            0.25 + 2 * kHalfStep);
  EXPECT_EQ(Difference(0.25 + kHalfStep, SnapRule::kNearestAway, SnapForm::kExactDifference), 0.25);
  EXPECT_EQ(Difference(0.75 + kHalfStep, SnapRule::kTruncate, SnapForm::kExactDifference), 0.75);
  EXPECT_EQ(SnapCoordinate(3.2, {0, SnapRule::kNearestEven, SnapForm::kExactDifference, 0.5}), 3.5);
  EXPECT_EQ(SnapCoordinate(3, {8, SnapRule::kFloor, SnapForm::kExactDifference, 0x1p-8}), 3);
}

// One step of float32 above a tie, where x - 1/2 is coarser than x.
TEST(SnapTest, Float32RoundsTheDifferenceOntoATie) {
  const double tie = 0.125 + kHalfStep;
  const double above = tie + 0x1p-27;
  EXPECT_EQ(Difference(above, SnapRule::kHalfUp, SnapForm::kExactDifference),
            0.125 + 2 * kHalfStep);
  EXPECT_EQ(Difference(above, SnapRule::kNearestAway, SnapForm::kExactDifference),
            0.125 + 2 * kHalfStep);
  EXPECT_EQ(Difference(above, SnapRule::kNearestAway, SnapForm::kFloat32Difference), 0.125);
  EXPECT_EQ(Difference(tie - 0x1p-27, SnapRule::kHalfUp, SnapForm::kExactDifference), 0.125);
  EXPECT_EQ(Difference(tie - 0x1p-27, SnapRule::kHalfUp, SnapForm::kFloat32Difference),
            0.125 + 2 * kHalfStep);
}

TEST(SnapTest, NoDifferenceIsTooFineToBeExact) {
  // Beside the origin a double has no room for 2^-1000, and the floor must see it all the same.
  EXPECT_EQ(Difference(-0x1p-1000, SnapRule::kFloor, SnapForm::kExactDifference), -0x1p-8);
  EXPECT_EQ(Difference(+0x1p-1000, SnapRule::kFloor, SnapForm::kExactDifference), 0);
  EXPECT_EQ(Difference(-0x1p-1000, SnapRule::kFloor, SnapForm::kFloat32Difference), 0);
  EXPECT_EQ(Difference(kHalfStep - 0x1p-60, SnapRule::kHalfUp, SnapForm::kExactDifference), 0);
  // Twice rounded, 1/2 - 2^-26 - 2^-60 would pass through the float32 tie 1/2 - 2^-26.
  EXPECT_EQ(SnapCoordinate(0x1p-26 + 0x1p-60,
                           {16, SnapRule::kTruncate, SnapForm::kFloat32Difference, 0.5}),
            0x1p-16);
}

TEST(SnapTest, AToleranceLeavesTheGridPointsNearby) {
  using Points = std::vector<double>;
  const Snap snap{2, SnapRule::kNearestEven};
  EXPECT_EQ(GridPointsWithin(0.5, snap, 0), (Points{0.5}));
  EXPECT_EQ(GridPointsWithin(0.5, snap, 0.6), (Points{0.5}));
  EXPECT_EQ(GridPointsWithin(0.625, snap, 0.6), (Points{0.5, 0.75}));
  EXPECT_EQ(GridPointsWithin(0.5625, snap, 0.6), (Points{0.5}));
  EXPECT_EQ(GridPointsWithin(0.5625, snap, 1), (Points{0.5, 0.75}));
  EXPECT_EQ(GridPointsWithin(0.5, snap, 1), (Points{0.25, 0.5, 0.75}));
  EXPECT_EQ(GridPointsWithin(-0.625, snap, 0.6), (Points{-0.75, -0.5}));
  // The rule's own point is legal even where the tolerance is less than the rule strays.
  EXPECT_EQ(GridPointsWithin(0.7, {2, SnapRule::kFloor}, 0.5), (Points{0.5, 0.75}));
  EXPECT_EQ(GridPointsWithin(3.4, {0, SnapRule::kNearestEven, SnapForm::kExactDifference, 0.5}, 1),
            (Points{2.5, 3.5}));
  EXPECT_EQ(GridPointsWithin(0.3, Snap{}, 1), (Points{0.3}));
}

// Float32 takes x - 1/256 to x here, and the snap sixteen steps away from x.
TEST(SnapTest, AToleranceKeepsThePointOfADifferenceThatRoundsFarOff) {
  using Points = std::vector<double>;
  constexpr double kFar = 0x1p20 + 1;
  const Snap snap{12, SnapRule::kNearestEven, SnapForm::kFloat32Difference, 0x1p-8};
  EXPECT_EQ(GridPointsWithin(kFar, snap, 0.6), (Points{kFar, kFar + 0x1p-8}));
}

// A distance that only its rounding brings down to the tolerance is beyond it.
TEST(SnapTest, AToleranceEndsWhereItSays) {
  using Points = std::vector<double>;
  const Snap quarter{2, SnapRule::kNearestEven};
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(GridPointsWithin(tiny, quarter, 1), (Points{0, 0.25}));
  EXPECT_EQ(GridPointsWithin(-tiny, quarter, 1), (Points{-0.25, 0}));
  EXPECT_EQ(GridPointsWithin(0.25 - 0x1p-55, quarter, 1), (Points{0, 0.25}));
  EXPECT_EQ(GridPointsWithin(0.25 + 0x1p-54, quarter, 1), (Points{0.25, 0.5}));
  EXPECT_EQ(GridPointsWithin(0.25, quarter, 1), (Points{0, 0.25, 0.5}));
  EXPECT_EQ(GridPointsWithin(0.375 - 0x1p-54, quarter, 0.5), (Points{0.25}));
  EXPECT_EQ(GridPointsWithin(0.375 + 0x1p-54, quarter, 0.5), (Points{0.5}));
  EXPECT_EQ(GridPointsWithin(0.375, quarter, 0.5), (Points{0.25, 0.5}));
}

TEST(SnapTest, AToleranceOfFarCoordinatesIsExactUpToItsDomain) {
  using Points = std::vector<double>;
  const Snap fine{kMaxSubpixelBits, SnapRule::kFloor};
  const double step = 0x1p-16;
  EXPECT_EQ(GridPointsWithin(0x1p36 - step / 2, fine, 1), (Points{0x1p36 - step, 0x1p36}));
  EXPECT_EQ(GridPointsWithin(step / 2 - 0x1p36, fine, 1), (Points{-0x1p36, step - 0x1p36}));
  EXPECT_EQ(GridPointsWithin(0x1p36 - step, fine, 1),
            (Points{0x1p36 - 2 * step, 0x1p36 - step, 0x1p36}));
  for (const double far : {0x1p36, 0x1p52 + 1, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(GridPointsWithin(far, fine, 1), (Points{far}));
    EXPECT_EQ(GridPointsWithin(-far, fine, 1), (Points{-far}));
  }
}

}  // namespace
}  // namespace rasterproof
