#include "io/number_text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

double Decimal32(const std::string& text) {
  const NumberFromText number = DecimalNumber(text, Precision::kFloat32);
  EXPECT_EQ(number.fault, "") << text;
  return number.value;
}

std::uint64_t Bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// Just above the tie between 1 and 1 + 2^-23: by way of float64 it lands on the tie, and goes to 1.
TEST(DecimalNumberTest, RoundsToFloat32Once) {
  const std::string above = "1.00000005960464477539062500000000001";
  EXPECT_EQ(static_cast<float>(std::strtod(above.c_str(), nullptr)), 1.0F);
  EXPECT_EQ(Decimal32(above), 1 + 0x1p-23);
  EXPECT_EQ(Decimal32("1.000000059604644775390625"), 1.0);
  EXPECT_EQ(Decimal32("1.00000017881393432617187499999999999"), 1 + 0x1p-23);
}

TEST(DecimalNumberTest, IntegersBeyondTheMantissaRoundOnce) {
  EXPECT_EQ(Decimal32("16777217"), 16777216.0);
  EXPECT_EQ(Decimal32("16777219"), 16777220.0);
  // 2^53 + 2^29 + 1: the tie of float32 plus one, which float64 can't hold.
  EXPECT_EQ(Decimal32("9007199791611905"), 0x1.000002p53);
  EXPECT_EQ(DecimalNumber("9007199254740993", Precision::kFloat64).value, 9007199254740992.0);
}

TEST(DecimalNumberTest, ZeroKeepsItsSign) {
  for (const char* text : {"-0", "-0.0", "-0e99999999999999999999", "-1e-400", "-1e-60"}) {
    EXPECT_EQ(Bits(Decimal32(text)), Bits(-0.0)) << text;
  }
  EXPECT_EQ(Bits(Decimal32("1e-99999999999999999999")), Bits(0.0));
}

TEST(DecimalNumberTest, SubnormalsAreNearestToo) {
  EXPECT_EQ(Decimal32("1e-45"), 0x1p-149);
  // 2^-150 lies half way between 0 and the smallest subnormal: ties go to the even one, 0.
  EXPECT_EQ(Decimal32("7.006492321624085354618e-46"), 0.0);
  EXPECT_EQ(Decimal32("7.006492321624085354619e-46"), 0x1p-149);
  EXPECT_EQ(DecimalNumber("5e-324", Precision::kFloat64).value, 0x1p-1074);
}

TEST(DecimalNumberTest, OnlyRoundingToInfinityIsAFault) {
  EXPECT_EQ(Decimal32("3.4028235677973366e38"), std::numeric_limits<float>::max());
  for (const char* text : {"3.4028235677973367e38", "1e39", "-1e400", "1e99999999999999999999"}) {
    EXPECT_EQ(DecimalNumber(text, Precision::kFloat32).fault, "rounds to infinity") << text;
  }
  EXPECT_EQ(DecimalNumber("1e39", Precision::kFloat64).fault, "");
  EXPECT_EQ(DecimalNumber("1e309", Precision::kFloat64).fault, "rounds to infinity");
  EXPECT_EQ(DecimalNumber("1" + std::string(400, '0'), Precision::kFloat64).fault,
            "rounds to infinity");
  EXPECT_EQ(DecimalNumber("0." + std::string(400, '0') + "1", Precision::kFloat64).fault, "");
}

TEST(ExactNumberTest, ReadsHexFloatsInfinitiesAndNan) {
  EXPECT_EQ(ExactNumber("0x1.8p+3", Precision::kFloat32).value, 12);
  EXPECT_EQ(ExactNumber("-0X.8P1", Precision::kFloat32).value, -1);
  EXPECT_EQ(ExactNumber("+0x10.p-4", Precision::kFloat32).value, 1);
  EXPECT_EQ(ExactNumber("0x1p-149", Precision::kFloat32).value, 0x1p-149);
  EXPECT_EQ(ExactNumber("0x0.0000000000001p-1022", Precision::kFloat64).value, 0x1p-1074);
  EXPECT_EQ(ExactNumber("-inf", Precision::kFloat32).value, -HUGE_VAL);
  EXPECT_TRUE(std::isnan(ExactNumber("nan", Precision::kFloat32).value));
  EXPECT_EQ(Bits(ExactNumber("-0x0p999999999999999999999", Precision::kFloat32).value), Bits(-0.0));
}

TEST(ExactNumberTest, LongMantissasAndExponentsAreTakenAtTheirValue) {
  const std::string zeros(300, '0');
  EXPECT_EQ(ExactNumber("0x1." + zeros + "p0", Precision::kFloat32).value, 1);
  EXPECT_EQ(ExactNumber("0x0." + zeros + "1p1204", Precision::kFloat32).value, 1);
  EXPECT_EQ(ExactNumber("0x1" + zeros + "p-1200", Precision::kFloat32).value, 1);
  EXPECT_EQ(ExactNumber("0x1." + zeros + "1p0", Precision::kFloat64).fault,
            "is not exactly a float64");
}

TEST(ExactNumberTest, WhatThePrecisionDoesNotHoldIsAFault) {
  for (const char* text : {"0x1.000001p0", "0x1p128", "0x1p-150", "0x1.8p-149", "0x1.ffffffp127",
                           "0x1p99999999999999999999", "0x1p-99999999999999999999"}) {
    EXPECT_EQ(ExactNumber(text, Precision::kFloat32).fault, "is not exactly a float32") << text;
  }
  EXPECT_EQ(ExactNumber("0x1.fffffep127", Precision::kFloat32).fault, "");
  EXPECT_EQ(ExactNumber("0x1.00000000000008p0", Precision::kFloat64).fault,
            "is not exactly a float64");
  EXPECT_EQ(ExactNumber("0x1.fffffffffffffp1023", Precision::kFloat64).fault, "");
}

TEST(ExactNumberTest, MalformedTextIsAFault) {
  for (const char* text :
       {"",         "1.5",      "0x",     "0xp0",   "0x1",    "0x1.8", "0x1p",    "0x1p+",
        "0x.p0",    "0x1..0p0", "0x1p0 ", " 0x1p0", "0x1p0f", "0xgp0", "--0x1p0", "0x1p0x",
        "infinity", "INF",      "+inf",   "NaN",    "-nan",   "nan(1)"}) {
    EXPECT_NE(ExactNumber(text, Precision::kFloat64).fault, "") << text;
  }
}

TEST(ExactTextTest, EveryBitPatternReadsBack) {
  std::mt19937_64 random(20);
  for (int k = 0; k < 100000; ++k) {
    const double x = std::bit_cast<double>(random());
    const double back = ExactNumber(ExactText(x), Precision::kFloat64).value;
    if (std::isnan(x)) {
      ASSERT_TRUE(std::isnan(back));
    } else {
      ASSERT_EQ(Bits(back), Bits(x)) << ExactText(x);
    }
    const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isnan(f)) continue;
    const NumberFromText single = ExactNumber(ExactText(f), Precision::kFloat32);
    ASSERT_EQ(single.fault, "") << ExactText(f);
    ASSERT_EQ(Bits(single.value), Bits(f));
  }
}

// Against the C library, which rounds correctly; texts of random values and of ties between them.
TEST(DecimalNumberTest, AgreesWithTheCLibraryNearTies) {
  std::mt19937_64 random(21);
  for (int k = 0; k < 20000; ++k) {
    const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(f) || std::fabs(f) > 0x1p126F) continue;
    const double tie = (double{f} + std::nextafter(f, HUGE_VALF)) / 2;
    for (const double x : {double{f}, tie, std::nextafter(tie, HUGE_VAL)}) {
      std::string text(1600, ' ');
      text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.1100e", x)));
      ASSERT_EQ(Decimal32(text), std::strtof(text.c_str(), nullptr)) << text.substr(0, 30);
    }
  }
}

}  // namespace
}  // namespace rasterproof::io
