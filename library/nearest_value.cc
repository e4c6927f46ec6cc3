#include "library/nearest_value.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "library/triple_sum.h"

namespace rasterproof::library {
namespace {

// A product of beta_i: product and at are exact.
struct ValueTerm {
  double product = 0;
  double at = 0;
  std::size_t corner = 0;
};
using ValueTerms = std::array<ValueTerm, 18>;

ValueTerms TermsOf(const ValueQuotient& q, double x, double y) {
  ValueTerms terms;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    terms[count++] = {q.y[j] * q.w[k], x, i};
    terms[count++] = {-q.w[j] * q.y[k], x, i};
    terms[count++] = {q.w[j] * q.x[k], y, i};
    terms[count++] = {-q.x[j] * q.w[k], y, i};
    terms[count++] = {q.x[j] * q.y[k], 1, i};
    terms[count++] = {-q.y[j] * q.x[k], 1, i};
  }
  return terms;
}

// Floats in their order: 0 of both zeros, then 1, 2, ... upwards and -1, -2, ... downwards.
constexpr std::int64_t kLargest = 0x7f7fffff;

float FloatAt(std::int64_t place) {
  const float magnitude = std::bit_cast<float>(static_cast<std::uint32_t>(std::abs(place)));
  return place < 0 ? -magnitude : magnitude;
}
std::int64_t FloatPlaceOf(double value) {
  const auto bits =
      std::int64_t{std::bit_cast<std::uint32_t>(static_cast<float>(std::fabs(value)))};
  return std::copysign(1.0, value) < 0 ? -std::min(bits, kLargest) : std::min(bits, kLargest);
}

struct Places {
  std::int64_t low = -kLargest;
  std::int64_t high = kLargest;
};

// At most 2 roundings of a product, 17 of sums, as many in d, and the quotient: 24 covers them,
// those of the error and of both ends.
Places GuessedPlaces(const ValueQuotient& q, const ValueTerms& terms) {
  constexpr double kOff = 24 * 0x1p-53;
  double n = 0;
  double d = 0;
  double n_reach = 0;
  double d_reach = 0;
  for (const ValueTerm& term : terms) {
    const double product = term.product * term.at;
    const double of_n = product * q.c[term.corner];
    const double of_d = product * q.e[term.corner];
    n += of_n;
    d += of_d;
    n_reach += std::fabs(of_n);
    d_reach += std::fabs(of_d);
  }
  const double least = std::fabs(d) - kOff * d_reach;
  if (!(least > 0)) return {};
  const double value = n / d;
  const double error = kOff * ((n_reach + std::fabs(value) * d_reach) / least);
  if (!(std::fabs(value) + error < std::numeric_limits<double>::infinity())) return {};
  return {FloatPlaceOf(value - error), FloatPlaceOf(value + error)};
}

int SignOfDenominator(const ValueQuotient& q, const ValueTerms& terms) {
  TripleSum d;
  for (const ValueTerm& term : terms) d.Add(term.product, term.at, q.e[term.corner]);
  return d.Sign();
}

// The sign of 2 n - (a + b) d: of the value less the middle of a and b, but for that of d.
int SignAtMiddle(const ValueQuotient& q, const ValueTerms& terms, double a, double b) {
  TripleSum sum;
  for (const ValueTerm& term : terms) {
    sum.Add(term.product, term.at, 2 * q.c[term.corner]);
    sum.Subtract(term.product, term.at, a * q.e[term.corner]);
    sum.Subtract(term.product, term.at, b * q.e[term.corner]);
  }
  return sum.Sign();
}

}  // namespace

float NearestValue(const ValueQuotient& q, double x, double y) {
  const ValueTerms terms = TermsOf(q, x, y);
  auto [low, high] = GuessedPlaces(q, terms);
  if (low == high) return FloatAt(low);
  const int side = SignOfDenominator(q, terms);
  if (side == 0) return std::numeric_limits<float>::quiet_NaN();
  // The first float, from below, that the value is not rounded above.
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    const int sign = side * SignAtMiddle(q, terms, FloatAt(middle), FloatAt(middle + 1));
    const bool is_above = sign > 0 || (sign == 0 && middle % 2 != 0);
    if (is_above) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return FloatAt(low);
}

}  // namespace rasterproof::library
