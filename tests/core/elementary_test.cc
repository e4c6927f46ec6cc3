#include "core/elementary.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace rasterproof {
namespace {

constexpr int kBits = 160;
constexpr int kCases = 100000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A number of 160 bits.
class Precise {
 public:
  explicit Precise(double x = 0) {
    mpfr_init2(value_, kBits);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  Precise(const Precise&) = delete;
  Precise& operator=(const Precise&) = delete;
  ~Precise() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  double Rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }

 private:
  mpfr_t value_;
};

// The distance of x from the exact value, in ulps of that.
double ErrorInUlps(double x, Precise& exact) {
  int exponent = 0;
  std::frexp(exact.Rounded(), &exponent);
  Precise off;
  mpfr_sub_d(off.get(), exact.get(), x, MPFR_RNDN);
  return std::fabs(off.Rounded()) / std::ldexp(1.0, std::max(exponent - 53, -1074));
}

class ElementaryTest : public ::testing::Test {
 protected:
  double Uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random_() >> 11U), -53);
  }
  // Of either sign, of every size from 2^low to 2^high.
  double OfEverySize(int low, int high) {
    const double size = std::ldexp(Uniform(1, 2), static_cast<int>(std::floor(Uniform(low, high))));
    return random_() % 2 == 0 ? size : -size;
  }

 private:
  std::mt19937_64 random_{1};
};

TEST_F(ElementaryTest, SinPiAndCosPiAreOffByLessThanStated) {
  Precise pi;
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  double worst = 0;
  for (int k = 0; k < kCases; ++k) {
    const double x = k % 2 == 0 ? Uniform(-2, 2) : OfEverySize(-60, 10);
    Precise angle(x);
    mpfr_mul(angle.get(), angle.get(), pi.get(), MPFR_RNDN);
    Precise sine;
    Precise cosine;
    mpfr_sin_cos(sine.get(), cosine.get(), angle.get(), MPFR_RNDN);
    worst = std::max({worst, ErrorInUlps(SinPi(x), sine), ErrorInUlps(CosPi(x), cosine)});
  }
  EXPECT_LE(worst, kSinPiUlps);
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(ElementaryTest, SinPiAndCosPiAreExactAtQuarterTurns) {
  for (const double turns : {0.0, 1.0, -3.0, 0x1p40}) {
    for (const auto& [quarter, sine] : {std::pair{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}, {1.5, -1.0}}) {
      EXPECT_EQ(SinPi(2 * turns + quarter), sine);
      EXPECT_EQ(CosPi(2 * turns + quarter - 0.5), sine);
    }
  }
}

TEST_F(ElementaryTest, Exp2IsOffByLessThanStated) {
  double worst = 0;
  for (int k = 0; k < kCases; ++k) {
    const double x = k % 2 == 0 ? Uniform(-16, 16) : Uniform(-1022, 1023);
    Precise power(x);
    mpfr_exp2(power.get(), power.get(), MPFR_RNDN);
    worst = std::max(worst, ErrorInUlps(Exp2(x), power));
  }
  EXPECT_LE(worst, kExp2Ulps);
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(ElementaryTest, Log2IsOffByLessThanStated) {
  double worst = 0;
  for (int k = 0; k < kCases; ++k) {
    const double x = k % 2 == 0 ? Uniform(0.5, 2) : std::fabs(OfEverySize(-1074, 1023));
    Precise logarithm(x);
    mpfr_log2(logarithm.get(), logarithm.get(), MPFR_RNDN);
    worst = std::max(worst, ErrorInUlps(Log2(x), logarithm));
  }
  EXPECT_LE(worst, kLog2Ulps);
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(ElementaryTest, PowersOfTwoAndTheirLogarithmsAreExact) {
  for (int k = -1022; k <= 1023; ++k) {
    EXPECT_EQ(Exp2(k), std::ldexp(1.0, k));
    EXPECT_EQ(Log2(std::ldexp(1.0, k)), k);
  }
}

TEST_F(ElementaryTest, HypotIsOffByLessThanStated) {
  double worst = 0;
  for (int k = 0; k < kCases; ++k) {
    const int size = k % 4 == 0 ? -1074 : k % 4 == 1 ? 960 : 0;
    const double x = OfEverySize(size, size + 60);
    const double y = OfEverySize(size, size + 60);
    Precise exact_x(x);
    Precise exact_y(y);
    Precise length;
    mpfr_hypot(length.get(), exact_x.get(), exact_y.get(), MPFR_RNDN);
    worst = std::max(worst, ErrorInUlps(Hypot(x, y), length));
  }
  EXPECT_LE(worst, kHypotUlps);
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(ElementaryTest, HypotHoldsAtTheEndsOfTheDoubles) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Hypot(3 * kSmallest, -4 * kSmallest), 5 * kSmallest);
  EXPECT_EQ(Hypot(0x1.8p1022, 0x1p1023), 0x1.4p1023);
  EXPECT_EQ(Hypot(0, -kLargest), kLargest);
  EXPECT_EQ(Hypot(kLargest, kSmallest), kLargest);
  EXPECT_EQ(Hypot(kLargest, kLargest), kInfinity);
  EXPECT_EQ(Hypot(kNaN, -kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(Hypot(kNaN, 0)));
  EXPECT_EQ(Hypot(0, 0), 0);
}

}  // namespace
}  // namespace rasterproof
