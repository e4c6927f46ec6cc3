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

}  // namespace
}  // namespace rasterproof::report
