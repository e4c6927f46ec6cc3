#include "exact/attributes.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"

namespace rasterproof::exact {
namespace {

// The value of T's bit pattern, the one after the largest being 2^max_exponent: rounding to nearest
// treats infinity as if it stood there.
template <class T>
Rational Place(BitsOf<T> bits) {
  const T value = std::bit_cast<T>(bits);
  if (std::isinf(value))
    return Place<T>(bits - 1) +
           std::ldexp(T{1}, std::numeric_limits<T>::max_exponent - std::numeric_limits<T>::digits);
  return Rational(value);
}

// The largest value of T whose square is at most `square`, as a bit pattern: patterns of
// non-negative values are ordered as the values are.
template <class T>
BitsOf<T> FloorOfSquareRoot(const Rational& square) {
  BitsOf<T> low = 0;
  BitsOf<T> high = std::bit_cast<BitsOf<T>>(std::numeric_limits<T>::infinity());
  while (high - low > 1) {
    const BitsOf<T> middle = low + (high - low) / 2;
    const Rational candidate = Place<T>(middle);
    (candidate * candidate <= square ? low : high) = middle;
  }
  return low;
}

template <class T>
T RoundedSquareRoot(const Rational& square) {
  const BitsOf<T> low = FloorOfSquareRoot<T>(square);
  // Rounds up if the root lies beyond the midpoint, or on it with the lower neighbour odd.
  const Rational twice_midpoint = Place<T>(low) + Place<T>(low + 1);
  const auto against = square * 4.0 <=> twice_midpoint * twice_midpoint;
  const bool up = against > 0 || (against == 0 && (low & 1) != 0);
  return std::bit_cast<T>(up ? low + 1 : low);
}

}  // namespace

std::optional<std::array<Rational, 3>> Barycentrics(const std::array<Point2, 3>& v, Point2 p) {
  const Rational area = EdgeValue(v[0], v[1], v[2]);
  if (area.Sign() == 0) return std::nullopt;
  return std::array<Rational, 3>{EdgeValue(v[1], v[2], p) / area, EdgeValue(v[2], v[0], p) / area,
                                 EdgeValue(v[0], v[1], p) / area};
}

std::optional<Rational> Interpolate(const std::array<Point2, 3>& v,
                                    const std::array<double, 3>& attribute, Point2 p) {
  const auto lambda = Barycentrics(v, p);
  if (!lambda) return std::nullopt;
  return (*lambda)[0] * attribute[0] + (*lambda)[1] * attribute[1] + (*lambda)[2] * attribute[2];
}

std::optional<Rational> InterpolatePerspective(const std::array<Point2, 3>& v,
                                               const std::array<double, 3>& w,
                                               const std::array<double, 3>& attribute, Point2 p) {
  const auto lambda = Barycentrics(v, p);
  if (!lambda || w[0] == 0 || w[1] == 0 || w[2] == 0) return std::nullopt;
  Rational numerator;
  Rational denominator;
  for (unsigned k = 0; k < 3; ++k) {
    const Rational barycentric = (*lambda)[k] / w[k];
    numerator += barycentric * attribute[k];
    denominator += barycentric;
  }
  if (denominator.Sign() == 0) return std::nullopt;
  return numerator / denominator;
}

std::optional<Rational> SquaredLineDistance(Point2 a, Point2 b, Point2 p) {
  if (a == b) return std::nullopt;
  const Rational dx = Rational(b.x) - a.x;
  const Rational dy = Rational(b.y) - a.y;
  const Rational e = EdgeValue(a, b, p);
  return e * e / (dx * dx + dy * dy);
}

double NearestSquareRoot(const Rational& square) { return RoundedSquareRoot<double>(square); }
float NearestSquareRootFloat(const Rational& square) { return RoundedSquareRoot<float>(square); }

}  // namespace rasterproof::exact
