#include "exact/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/ulp.h"
#include "tests/exact/families.h"

namespace rasterproof::exact {
namespace {

constexpr double kMaxDouble = std::numeric_limits<double>::max();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Rational, CountsAsPeopleDo) {
  const Rational third = Rational(1) / 3;
  EXPECT_EQ((third + third + third).ToString(), "1");
  EXPECT_EQ((third - 1).ToString(), "-2/3");
  EXPECT_EQ((third * -6).ToString(), "-2");
  EXPECT_EQ((Rational(-7) / 2).Abs().ToString(), "7/2");
  EXPECT_EQ(Rational().ToString(), "0");
  EXPECT_LT(third, Rational(1) / 2);
  EXPECT_EQ(Rational(0.0), Rational(-0.0));
  EXPECT_EQ((-third).Sign(), -1);
}

TEST(Rational, RefusesWhatIsNotFinite) {
  EXPECT_THROW(Rational{kInf}, std::domain_error);
  EXPECT_THROW(Rational{std::nan("")}, std::domain_error);
}

TEST(Rational, GivesEveryDoubleBack) {
  Draw draw(3);
  for (int k = 0; k < 3000; ++k) {
    const double x = draw.Coordinate(static_cast<Family>(k % kFamilies));
    ASSERT_EQ(Rational(x).ToDouble(), x);
    ASSERT_EQ(Rational(x).ToDoubleUp(), x);
    ASSERT_EQ(Rational(x).ToFloat(), static_cast<float>(x));
  }
}

// The processor rounds quotients of doubles correctly: an independent witness, subnormals included.
TEST(Rational, RoundsQuotientsAsTheProcessorDoes) {
  Draw draw(4);
  int subnormal = 0;
  for (int k = 0; k < 3000; ++k) {
    const double n = draw.Coordinate(static_cast<Family>(k % kFamilies));
    const double d = draw.Coordinate(static_cast<Family>((k / 7) % kFamilies));
    if (d == 0) continue;
    ASSERT_EQ((Rational(n) / d).ToDouble(), n / d) << n << " / " << d;
    if (std::fpclassify(n / d) == FP_SUBNORMAL) ++subnormal;
    const auto nf = static_cast<float>(n);
    const auto df = static_cast<float>(d);
    if (std::isfinite(nf) && std::isfinite(df) && df != 0) {
      ASSERT_EQ((Rational(double{nf}) / double{df}).ToFloat(), nf / df);
    }
  }
  EXPECT_GT(subnormal, 20);
}

TEST(Rational, RoundsTiesToEvenAtEveryPlaceThatDiffers) {
  const Rational half_ulp(0x1p-53);
  EXPECT_EQ((Rational(1) + half_ulp).ToDouble(), 1);
  EXPECT_EQ((Rational(1 + 0x1p-52) + half_ulp).ToDouble(), 1 + 0x1p-51);
  EXPECT_EQ((Rational(1) + half_ulp + 0x1p-1074).ToDouble(), 1 + 0x1p-52);
  EXPECT_EQ((Rational(0x1p-1074) / 2).ToDouble(), 0);
  EXPECT_EQ((Rational(0x1p-1074) * 3 / 2).ToDouble(), 0x1p-1073);
  EXPECT_EQ((Rational(kMaxDouble) + 0x1p969).ToDouble(), kMaxDouble);
  EXPECT_EQ((Rational(kMaxDouble) + 0x1p970).ToDouble(), kInf) << "half an ulp beyond: to even, up";
  EXPECT_EQ((Rational(kMaxDouble) * kMaxDouble).ToDouble(), kInf);
  EXPECT_EQ((Rational(-kMaxDouble) * kMaxDouble).ToDouble(), -kInf);
  EXPECT_EQ(Rational(0x1p-150).ToFloat(), 0.0F);
  EXPECT_EQ(Rational(0x1.8p-149).ToFloat(), 0x1p-148F);
}

TEST(Rational, RoundsUpToTheSmallestDoubleNotBelow) {
  const Rational third = Rational(1) / 3;
  EXPECT_EQ(third.ToDoubleUp(), std::nextafter(1.0 / 3, 1.0));
  EXPECT_EQ((-third).ToDoubleUp(), -(1.0 / 3));
  EXPECT_EQ((Rational(0x1p-1074) / 4).ToDoubleUp(), 0x1p-1074);
  EXPECT_EQ((-Rational(0x1p-1074) / 4).ToDoubleUp(), 0);
  EXPECT_EQ((Rational(kMaxDouble) * 2).ToDoubleUp(), kInf);
  EXPECT_EQ((Rational(-kMaxDouble) * 2).ToDoubleUp(), -kMaxDouble);
}

}  // namespace
}  // namespace rasterproof::exact
