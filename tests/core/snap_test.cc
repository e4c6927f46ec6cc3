#include "core/snap.h"

#include <cmath>
#include <limits>

#include "gtest/gtest.h"

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

TEST(SnapTest, NamesReadBack) {
  for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kNearestAway, SnapRule::kHalfUp,
                              SnapRule::kFloor, SnapRule::kTruncate}) {
    EXPECT_EQ(SnapRuleFromName(SnapRuleName(rule)), rule);
  }
}

}  // namespace
}  // namespace rasterproof
