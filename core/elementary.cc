#include "core/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

// What rounds here is + - * / and sqrt alone, which IEEE 754 defines to the last bit.
namespace rasterproof {
namespace {

// The sum of c[k] x^k.
template <std::size_t kTerms>
double Polynomial(const std::array<double, kTerms>& c, double x) {
  double sum = 0;
  for (std::size_t k = kTerms; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

// 1 / (first!), 1 / ((first + step)!), ..., of sign^k.
template <std::size_t kTerms>
constexpr std::array<double, kTerms> InverseFactorials(int first, int step, double sign) {
  std::array<double, kTerms> c{};
  double factorial = 1;  // exact up to 18!
  int n = 0;
  for (std::size_t k = 0; k < kTerms; ++k) {
    const int end = first + static_cast<int>(k) * step;
    while (n < end) factorial *= ++n;
    c[k] = (k % 2 == 1 ? sign : 1) / factorial;
  }
  return c;
}

// Up to |t| = pi / 4 the terms left out are less than 2^-63 of the sum.
double SinNearZero(double t) {
  static constexpr auto kTaylor = InverseFactorials<8>(3, 2, -1);
  const double square = t * t;
  return t - t * square * Polynomial(kTaylor, square);
}

double CosNearZero(double t) {
  static constexpr auto kTaylor = InverseFactorials<8>(4, 2, -1);
  const double square = t * t;
  return 1 - (square / 2 - square * square * Polynomial(kTaylor, square));
}

// sin(pi (x + quarters / 2)).
double SinPiFrom(double x, int quarters) {
  const double rest = std::fmod(x, 2.0);
  const double nearest = std::nearbyint(2 * rest);
  const double t = std::numbers::pi * (rest - nearest / 2);  // the difference is exact
  const int quadrant = (static_cast<int>(nearest) + quarters) & 3;
  const double size = quadrant % 2 == 0 ? SinNearZero(t) : CosNearZero(t);
  return quadrant < 2 ? size : -size;
}

// Of x >= y > 0 whose squares neither overflow nor lose bits. A Newton step from the rounded root,
// with the residual by differences that cancel exactly.
double HypotOfOrdered(double x, double y) {
  const double h = std::sqrt(x * x + y * y);
  if (h <= 2 * y) {
    const double d = h - y;
    return h - (x * (2 * d - x) + (d - 2 * (x - y)) * d) / (2 * h);
  }
  const double d = h - x;
  return h - (2 * d * (x - 2 * y) + ((4 * d - y) * y + d * d)) / (2 * h);
}

}  // namespace

double SinPi(double x) { return SinPiFrom(x, 0); }
double CosPi(double x) { return SinPiFrom(x, 1); }

double Exp2(double x) {
  // Up to |t| = ln 2 / 2 the terms left out are less than 2^-57.
  static constexpr auto kTaylor = InverseFactorials<14>(0, 1, 1);
  const double nearest = std::nearbyint(x);
  const double t = std::numbers::ln2 * (x - nearest);
  return std::ldexp(Polynomial(kTaylor, t), static_cast<int>(nearest));
}

double Log2(double x) {
  // ln m = 2 atanh s with s = (m - 1) / (m + 1). Up to |s| = 3 - sqrt(8) the terms left out are
  // less than 2^-60 of the sum.
  static constexpr std::array<double, 11> kTaylor{1,        1.0 / 3,  1.0 / 5,  1.0 / 7,
                                                  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15,
                                                  1.0 / 17, 1.0 / 19, 1.0 / 21};
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 1 / std::numbers::sqrt2) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1);
  return exponent + 2 * std::numbers::log2e * s * Polynomial(kTaylor, s * s);
}

double Hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
  const auto [low, high] = std::minmax({std::fabs(x), std::fabs(y)});
  // Less than half an ulp beside the larger; NaN comes out of the sum as well.
  if (!(low > 0x1p-54 * high)) return high + low;
  if (high < 0x1p500 && low > 0x1p-450) return HypotOfOrdered(high, low);
  const int exponent = std::ilogb(high);
  return std::ldexp(HypotOfOrdered(std::ldexp(high, -exponent), std::ldexp(low, -exponent)),
                    exponent);
}

}  // namespace rasterproof
