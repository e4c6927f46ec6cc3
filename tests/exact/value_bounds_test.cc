// Bounds of shown values, and the formats that they are shown in.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/scene.h"
#include "exact/rational.h"
#include "exact/values.h"

namespace rasterproof::exact {
namespace {

TEST(Ulp, IsThatOfTheBinadeOfTheExactValue) {
  EXPECT_EQ(Ulp(1, Precision::kFloat32), Rational(0x1p-23));
  EXPECT_EQ(Ulp(-1, Precision::kFloat64), Rational(0x1p-52));
  EXPECT_EQ(Ulp(Rational(1) - 0x1p-900, Precision::kFloat64), Rational(0x1p-53))
      << "the binade below, though the nearest double is 1";
  EXPECT_EQ(Ulp(Rational(8) / 5, Precision::kFloat32), Rational(0x1p-23));
  for (const double small : {0.0, 0x1p-1074, 0x1p-127, 0x1p-126}) {
    EXPECT_EQ(Ulp(small, Precision::kFloat32), Rational(0x1p-149));
  }
  const Rational least = 0x1p-1074;
  EXPECT_EQ(Ulp(least * least, Precision::kFloat64), least);
  EXPECT_EQ(Ulp(0x1p-1021, Precision::kFloat64), Rational(0x1p-1073));
  EXPECT_EQ(Ulp(0x1p200, Precision::kFloat32), Rational(0x1p104)) << "of the largest binade";
  EXPECT_EQ(Ulp(Rational(0x1p1000) * 0x1p1000, Precision::kFloat64), Rational(0x1p971));
}

TEST(IsWithin, DecidesJustInsideAndJustOutside) {
  const Rational third = Rational(1) / 3;
  const double nearest = (1.0F / 3);
  // The nearest float32 is 1/3 + 2^-25 / 3 and its ulp 2^-25: a third of an ulp, exactly.
  const auto within = [&](double shown, double ulps) {
    return IsWithin(shown, third, 0, {ulps, 0, 0}, Precision::kFloat32);
  };
  EXPECT_EQ((Rational(nearest) - third) * 3, Rational(0x1p-25));
  EXPECT_TRUE(within(nearest, std::nextafter(1.0 / 3, 1.0)));
  EXPECT_FALSE(within(nearest, 1.0 / 3)) << "the double below a third";
  EXPECT_FALSE(within(std::nextafter(nearest, 1.0), std::nextafter(1.0 / 3, 1.0)));
  EXPECT_FALSE(within(nearest - 0x1p-25, 0.5));
  EXPECT_TRUE(within(nearest - 0x1p-25, 0.75));
  // All three parts add up, in float64: 2^-52 + 2^-60 + 2^-53 * 10.
  const ValueError bound{1, 0x1p-60, 2};
  const double edge = 1 + 0x1p-52 * 6;
  EXPECT_TRUE(IsWithin(edge, Rational(1) - 0x1p-60, 5, {2, 0x1p-60, 2}, Precision::kFloat64))
      << "on the bound: two ulps of the binade below";
  EXPECT_FALSE(IsWithin(edge, Rational(1) - 0x1p-60, 5, {2, 0x1p-61, 2}, Precision::kFloat64));
  EXPECT_TRUE(IsWithin(edge, 1, 5, bound, Precision::kFloat64));
  EXPECT_FALSE(IsWithin(edge + 0x1p-52, 1, 5, bound, Precision::kFloat64));
  EXPECT_TRUE(IsWithin(1, 1, 0, {0, 0, 0}, Precision::kFloat32)) << "no bound: equal";
  EXPECT_FALSE(IsWithin(1, Rational(1) + Rational(0x1p-1074), 0, {0, 0, 0}, Precision::kFloat32));
}

TEST(IsWithin, IsNeverSoForWhatIsNoNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  const ValueError wide{1e300, 1e300, 1e300};
  for (const double shown : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    EXPECT_FALSE(IsWithin(shown, Rational(0x1p1023) * 4, 1, wide, Precision::kFloat64));
  }
  EXPECT_TRUE(IsWithin(1, 0, 1, wide, Precision::kFloat64));
}

TEST(ToUnorm, GivesBothNeighboursAndTheNearer) {
  for (const int bits : {1, 8, 16, 24, 32}) {
    const double largest = std::ldexp(1.0, bits) - 1;
    const auto top = static_cast<std::uint32_t>(largest);
    const auto expect = [&](const Rational& value, std::uint32_t floor, std::uint32_t ceiling,
                            int nearer) {
      const UnormCodes codes = ToUnorm(value, bits);
      EXPECT_EQ(codes.floor, floor);
      EXPECT_EQ(codes.ceiling, ceiling);
      EXPECT_EQ(codes.nearer, nearer);
    };
    const Rational least = Rational(0x1p-1000) * 0x1p-1000;
    const Rational half = Rational(0.5) / largest;
    expect(0, 0, 0, 0);
    expect(-least, 0, 0, 0);
    expect(least, 0, 1, -1);
    expect(half - least, 0, 1, -1);
    expect(half, 0, 1, 0);
    expect(half + least, 0, 1, +1);
    expect(1, top, top, 0);
    expect(Rational(1) + least, top, top, 0);
    expect(Rational(1) - least, top - 1, top, +1);
    expect(Rational(1) - half, top - 1, top, 0);
    expect(Rational(0x1p1023) * 0x1p1023, top, top, 0);
    const Rational exact = Rational(top / 3) / largest;
    expect(exact, top / 3, top / 3, 0);
    expect(exact + least, top / 3, top / 3 + 1, -1);
  }
}

TEST(ToUnorm, AllowsEitherCodeOfATie) {
  const UnormCodes tie = ToUnorm(0.5, 16);  // 32767.5
  EXPECT_TRUE(tie.IsNearest(32767));
  EXPECT_TRUE(tie.IsNearest(32768));
  EXPECT_FALSE(tie.IsNeighbour(32769));
  const UnormCodes below = ToUnorm(Rational(0.5) - 0x1p-40, 16);
  EXPECT_TRUE(below.IsNearest(32767));
  EXPECT_FALSE(below.IsNearest(32768));
  EXPECT_TRUE(below.IsNeighbour(32768));
}

}  // namespace
}  // namespace rasterproof::exact
