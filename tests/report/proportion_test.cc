// Intervals of shares that were counted.
#include "report/proportion.h"

#include <gtest/gtest.h>

namespace rasterproof::report {
namespace {

TEST(Proportion, IsWilsonsInterval) {
  const Interval half = ProportionInterval(50, 100);
  EXPECT_NEAR(half.low, 0.4038, 5e-5);
  EXPECT_NEAR(half.high, 0.5962, 5e-5);
  const Interval none = ProportionInterval(0, 100);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.0370, 5e-5);
  const Interval all = ProportionInterval(3, 3);
  EXPECT_NEAR(all.low, 0.4385, 5e-5);
  EXPECT_EQ(all.high, 1);
}

TEST(Proportion, IsWrittenWithoutAnExponent) {
  EXPECT_EQ(Percent(0), "0");
  EXPECT_EQ(Percent(0.0045), "0.45");
  EXPECT_EQ(Percent(0.371), "37");
  EXPECT_EQ(Percent(0.9949), "99");
  EXPECT_EQ(Percent(0.9951), "99.5");
  EXPECT_EQ(Percent(0.99951), "100");
  EXPECT_EQ(Percent(1), "100");
  EXPECT_EQ(CountedText(100, 100), "100 of 100, 96 to 100 %");
  EXPECT_EQ(CountedText(3, 100), "3 of 100, 1 to 8.5 %");
}

}  // namespace
}  // namespace rasterproof::report
