// The exact accumulator and the row crossings that rest on it.
#include "library/exact_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "library/row_crossing.h"
#include "tests/reference/brute_force.h"
#include "tests/reference/random_values.h"

namespace rasterproof::reference {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

TEST(ExactSumTest, EveryDoubleComesBackAsItself) {
  RandomValues random(61);
  for (int n = 0; n < 5000; ++n) {
    const double x = random.AnyFinite<double>();
    library::ExactSum sum;
    sum.Add(x, 1.0);
    EXPECT_EQ(sum.ToDouble(), x);
    EXPECT_EQ(sum.Sign(), x > 0 ? 1 : -1);
    sum.Subtract(x, 1.0);
    EXPECT_EQ(sum.Sign(), 0);
    EXPECT_EQ(sum.ToDouble(), 0);
  }
}

TEST(ExactSumTest, ProductsRoundOnceToNearestEven) {
  RandomValues random(62);
  for (int n = 0; n < 5000; ++n) {
    const double x = random.LogUniform<double>(-600, 600);
    const double y = random.LogUniform<double>(-600, 400);
    library::ExactSum sum;
    sum.Add(x, y);
    EXPECT_EQ(sum.ToDouble(), x * y);
  }
  library::ExactSum tie;
  tie.Add(1, 1);
  tie.Add(0x1p-53, 1);
  EXPECT_EQ(tie.ToDouble(), 1);
  tie.Add(kSmallest, kSmallest);
  EXPECT_EQ(tie.ToDouble(), 1 + 0x1p-52);
}

TEST(ExactSumTest, NothingIsLostBetweenTheEndsOfTheExponentRange) {
  library::ExactSum sum;
  sum.Add(kLargest, kLargest);
  EXPECT_EQ(sum.ToDouble(), std::numeric_limits<double>::infinity());
  sum.Subtract(kSmallest, kSmallest);
  sum.Subtract(kLargest, kLargest);
  EXPECT_EQ(sum.Sign(), -1);
  EXPECT_EQ(sum.ToDouble(), 0);
  sum.Add(kSmallest, kSmallest);
  EXPECT_EQ(sum.Sign(), 0);
  for (int n = 0; n < 1000; ++n) sum.Add(-kLargest, kLargest);
  EXPECT_EQ(sum.Sign(), -1);
}

TEST(ExactSumTest, CarriesRunThroughFullWords) {
  // 318 ones in a row and one more at the bottom, at every offset within a word.
  for (int offset = 0; offset < 64; ++offset) {
    library::ExactSum sum;
    for (int n = 0; n < 6; ++n) sum.Add(0x1p53 - 1, std::ldexp(1.0, offset + 53 * n));
    sum.Add(std::ldexp(1.0, offset), 1.0);
    EXPECT_EQ(sum.ToDouble(), std::ldexp(1.0, offset + 318));
    sum.Subtract(std::ldexp(1.0, offset), std::ldexp(1.0, 318));
    EXPECT_EQ(sum.Sign(), 0);
  }
}

// Crossings an ulp from a centre, far away, steep and flat: the guess must never be trusted too
// far.
TEST(RowCrossingTest, TheCrossingIsTheFirstColumnAtOrRightOfTheEdge) {
  RandomValues random(63);
  for (int n = 0; n < 3000; ++n) {
    const int j = random.Integer(0, 40);
    const int column = random.Integer(1, 62);
    const double y = j + 0.5;
    const double up = std::fabs(random.LogUniform<double>(-30, 30));
    const double down = std::fabs(random.LogUniform<double>(-30, 30));
    const double slope = random.LogUniform<double>(-20, 20);
    const double x = MoveByUlps(column + 0.5, random.Integer(-2, 2));
    const Point2 upper{x - up * slope, y - up};
    const Point2 lower{x + down * slope, y + down};
    if (!(upper.y <= y && y < lower.y)) continue;
    int expected = 0;
    while (expected < 64 && BruteForceEdgeSign(upper, lower, {expected + 0.5, y}) < 0) ++expected;
    EXPECT_EQ(library::RowCrossing(upper, lower).At(j, 0, 64), expected);
    EXPECT_EQ(library::RowCrossing(upper, lower).At(j, 5, 9), std::clamp(expected, 5, 9));
  }
}

}  // namespace
}  // namespace rasterproof::reference
