#include "exact/row_edge.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "exact/rational.h"
#include "exact/signs.h"
#include "model/snap.h"

namespace rasterproof::exact {
namespace {

// x rounded to odd: x if it is a double, else the neighbouring double whose last bit is one. No
// place at which a snap changes lies between it and x (Boldo and Melquiond, IEEE TC 2008).
double ToOdd(const Rational& x) {
  const double nearest = x.ToDouble();
  if (!std::isfinite(nearest)) return nearest;
  const int missed = (x - Rational(nearest)).Sign();
  const bool is_even = (std::bit_cast<std::uint64_t>(nearest) & 1) == 0;
  if (missed == 0 || !is_even) return nearest;
  return std::nextafter(nearest, missed > 0 ? HUGE_VAL : -HUGE_VAL);
}

Rational CrossingOf(Point2 upper, Point2 lower, double y) {
  const Rational slope =
      (Rational(lower.x) - Rational(upper.x)) / (Rational(lower.y) - Rational(upper.y));
  return Rational(upper.x) + (Rational(y) - Rational(upper.y)) * slope;
}

}  // namespace

int RowEdge::FirstColumnAtRounded(const SampleFrame& frame, int row, std::size_t s, int least_sign,
                                  std::uint64_t& certain) const {
  const double y = row + frame.offsets[s].y;
  const Guess guess = At(y, 0);
  const double low = SnapCoordinate(guess.at - guess.error, frame.scanline_rounding);
  const double high = SnapCoordinate(guess.at + guess.error, frame.scanline_rounding);
  ++(low == high ? certain : ThreadTiers().exact);
  const double x =
      low == high ? low
                  : SnapCoordinate(ToOdd(CrossingOf(upper_, lower_, y)), frame.scanline_rounding);
  // Exact near the target: a column of 17 bits, and at most 20 fractional ones in either.
  const double column = x - frame.offsets[s].x;
  const bool owns = least_sign == 0 || (frame.rule.IsConsistent() && frame.rule.sign_x > 0);
  return ClampedCeiling(owns ? column : std::floor(column) + 1, frame.clip.x0, frame.clip.x1);
}

}  // namespace rasterproof::exact
