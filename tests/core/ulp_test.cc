#include "core/ulp.h"

#include <limits>

#include "gtest/gtest.h"

namespace rasterproof {
namespace {

TEST(UlpTest, StepsCrossZeroAndBinades) {
  constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(MoveByUlps(0.0F, 1), kSmallest);
  EXPECT_EQ(MoveByUlps(-0.0F, -1), -kSmallest);
  EXPECT_EQ(MoveByUlps(kSmallest, -2), -kSmallest);
  EXPECT_EQ(MoveByUlps(1.0, -1), 1 - 0x1p-53);
  EXPECT_EQ(MoveByUlps(1.0, 1), 1 + 0x1p-52);
}

TEST(UlpTest, SaturatesAtTheLargestFiniteValue) {
  EXPECT_EQ(MoveByUlps(std::numeric_limits<float>::max(), 5), std::numeric_limits<float>::max());
  EXPECT_EQ(MoveByUlps(-std::numeric_limits<double>::max(), -1),
            -std::numeric_limits<double>::max());
}

TEST(UlpTest, RoundingEpsilonIsHalfTheGapAboveOne) {
  EXPECT_EQ(rounding_epsilon<float>(), 0x1p-24F);
  EXPECT_EQ(rounding_epsilon<double>(), 0x1p-53);
}

TEST(UlpTest, FloatValuesAreRecognised) {
  EXPECT_TRUE(IsFloat32(0.5));
  EXPECT_TRUE(IsFloat32(0x1p-149));
  EXPECT_FALSE(IsFloat32(0x1p-150));
  EXPECT_FALSE(IsFloat32(0.1));
  EXPECT_FALSE(IsFloat32(1e300));
}

}  // namespace
}  // namespace rasterproof
