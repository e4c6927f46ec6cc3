// Values that are correctly rounded: a filter in double, then exact sums.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/ulp.h"
#include "library/triple_sum.h"
#include "reference/value_methods.h"

namespace rasterproof::reference {
namespace {

// A product of two coordinates, high + low exactly, times that of the point.
struct BetaTerm {
  double high = 0;
  double low = 0;
  double at = 0;
  std::size_t corner = 0;
};

// The products of beta_0, beta_1, beta_2.
template <class T>
std::array<BetaTerm, 18> BetaTerms(const ValueTask<T>& task) {
  std::array<BetaTerm, 18> terms;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto add = [&](double x, double y, double at) {
      const double high = x * y;
      terms[count++] = {high, std::fma(x, y, -high), at, i};
    };
    const ValueCorner<T>& j = task.v[(i + 1) % 3];
    const ValueCorner<T>& k = task.v[(i + 2) % 3];
    add(j.y, k.w, task.x);
    add(-j.w, k.y, task.x);
    add(j.w, k.x, task.y);
    add(-j.x, k.w, task.y);
    add(j.x, k.y, 1);
    add(-j.y, k.x, 1);
  }
  return terms;
}

void AddTerm(library::TripleSum& sum, const BetaTerm& term, double factor) {
  sum.Add(term.high, term.at, factor);
  if (term.low != 0) sum.Add(term.low, term.at, factor);
}

// Of a product in n there are at most 20 roundings (two products of three, then 17 sums) and of one
// in d, with the quotient, as many: 24 covers them, the roundings of the error itself and those of
// both ends.
constexpr double kFilterConditions = 24;

// The number of T that the filter is sure of, or NaN.
template <class T>
T FilteredValue(const std::array<BetaTerm, 18>& terms, const std::array<T, 3>& a) {
  double n = 0;
  double d = 0;
  double n_reach = 0;
  double d_reach = 0;
  for (const BetaTerm& term : terms) {
    const double product = term.high * term.at;
    const double of_value = product * a[term.corner];
    n += of_value;
    d += product;
    n_reach += std::fabs(of_value);
    d_reach += std::fabs(product);
  }
  constexpr double kOff = kFilterConditions * 0x1p-53;
  const double least = std::fabs(d) - kOff * d_reach;
  if (!(least > 0)) return std::numeric_limits<T>::quiet_NaN();
  const double value = n / d;
  const double error = kOff * ((n_reach + std::fabs(value) * d_reach) / least);
  const T low = static_cast<T>(value - error);
  const T high = static_cast<T>(value + error);
  return low == high ? low : std::numeric_limits<T>::quiet_NaN();
}

int SignOfDenominator(const std::array<BetaTerm, 18>& terms) {
  library::TripleSum d;
  for (const BetaTerm& term : terms) AddTerm(d, term, 1);
  return d.Sign();
}

// The sign of 2 n - (c + next) d: of the value less the middle, but for the sign of d.
template <class T>
int SignAtMiddle(const std::array<BetaTerm, 18>& terms, const std::array<T, 3>& a, double c,
                 double next) {
  library::TripleSum sum;
  for (const BetaTerm& term : terms) {
    for (const double factor : {double{a[term.corner]}, double{a[term.corner]}, -c, -next}) {
      AddTerm(sum, term, factor);
    }
  }
  return sum.Sign();
}

}  // namespace

template <class T>
T CorrectlyRoundedValue(const ValueTask<T>& task) {
  const std::array<BetaTerm, 18> terms = BetaTerms(task);
  const T filtered = FilteredValue(terms, task.a);
  if (!std::isnan(filtered)) return filtered;
  const int side = SignOfDenominator(terms);
  if (side == 0) return std::numeric_limits<T>::quiet_NaN();
  // The first float, counted from 0, that the value is not rounded above.
  std::int64_t high = std::bit_cast<BitsOf<T>>(std::numeric_limits<T>::max());
  std::int64_t low = -high;
  while (low < high) {
    const std::int64_t middle = std::midpoint(low, high);  // towards low
    const T c = MoveByUlps(T{0}, middle);
    const int sign = side * SignAtMiddle(terms, task.a, c, MoveByUlps(T{0}, middle + 1));
    const bool is_above = sign > 0 || (sign == 0 && middle % 2 != 0);
    if (is_above) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return MoveByUlps(T{0}, low);
}

template float CorrectlyRoundedValue(const ValueTask<float>& task);
template double CorrectlyRoundedValue(const ValueTask<double>& task);

}  // namespace rasterproof::reference
