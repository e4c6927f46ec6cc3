#include "exact/attributes.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/channel.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "exact/values.h"

namespace rasterproof::exact {
namespace {

// The value of a bit pattern. The pattern after the largest value counts as 2^1024: rounding to
// nearest treats infinity as if it were that number.
Rational Place(std::uint64_t bits) {
  const auto value = std::bit_cast<double>(bits);
  return std::isinf(value) ? Place(bits - 1) + 0x1p971 : Rational(value);
}

// The largest double whose square is at most `square`, as a bit pattern: patterns of non-negative
// values are ordered as the values are.
std::uint64_t FloorOfSquareRoot(const Rational& square) {
  std::uint64_t low = 0;
  auto high = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    const Rational candidate = Place(middle);
    (candidate * candidate <= square ? low : high) = middle;
  }
  return low;
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
  return Interpolant(WindowTriangle(v), p).Value(Interpolation::kLinear, ToAttribute(attribute));
}

std::optional<Rational> InterpolatePerspective(const std::array<Point2, 3>& v,
                                               const std::array<double, 3>& w,
                                               const std::array<double, 3>& attribute, Point2 p) {
  return Interpolant(WindowTriangle(v, w), p)
      .Value(Interpolation::kPerspective, ToAttribute(attribute));
}

std::optional<Rational> SquaredLineDistance(Point2 a, Point2 b, Point2 p) {
  if (a == b) return std::nullopt;
  const Rational dx = Rational(b.x) - a.x;
  const Rational dy = Rational(b.y) - a.y;
  const Rational e = EdgeValue(a, b, p);
  return e * e / (dx * dx + dy * dy);
}

double NearestSquareRoot(const Rational& square) {
  const std::uint64_t low = FloorOfSquareRoot(square);
  // Rounds up if the root lies beyond the midpoint, or on it with the lower neighbour odd.
  const Rational twice_midpoint = Place(low) + Place(low + 1);
  const auto against = square * 4.0 <=> twice_midpoint * twice_midpoint;
  const bool up = against > 0 || (against == 0 && (low & 1) != 0);
  return std::bit_cast<double>(up ? low + 1 : low);
}

}  // namespace rasterproof::exact
