#include "model/snap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rasterproof {
namespace {

// The fraction v - trunc(v) is exact for every v; v - floor(v) is not: for -0.5 + 2^-54 it rounds
// to a tie.
double RoundByRule(double v, SnapRule rule) {
  const double whole = std::trunc(v);
  const double fraction = v - whole;  // has v's sign
  const double away = whole + (v < 0 ? -1 : 1);
  const double nearer = std::fabs(fraction) < 0.5 ? whole : away;
  const bool tie = std::fabs(fraction) == 0.5;
  switch (rule) {
    case SnapRule::kNearestEven:
      return tie && std::fmod(whole, 2.0) == 0 ? whole : nearer;
    case SnapRule::kNearestAway:
      return nearer;
    case SnapRule::kHalfUp:
      return tie && v < 0 ? whole : nearer;
    case SnapRule::kFloor:
      return v < 0 && fraction != 0 ? away : whole;
    case SnapRule::kTruncate:
      return whole;
  }
  return whole;
}

double SnapToMultiple(double x, int bits, SnapRule rule) {
  constexpr double kAllIntegersFrom = 0x1p52;  // every double of this magnitude is an integer
  if (std::fabs(x) >= kAllIntegersFrom) return x;
  // Scaling by a power of two is exact: |x| 2^bits < 2^68, and a subnormal x only grows.
  const double scaled = std::ldexp(x, bits);
  if (std::fabs(scaled) >= kAllIntegersFrom) return x;
  return std::ldexp(RoundByRule(scaled, rule), -bits) + 0.0;
}

// x - c rounded to odd: if it is not a double, its neighbour whose last bit is one. Later decisions
// at a coarser place (which float, which side of a half step) are then the same as for x - c,
// because no such place lies between the two (Boldo and Melquiond, IEEE TC 2008).
double DifferenceToOdd(double x, double c) {
  const double difference = x - c;
  const double from_x = difference + c;
  const double missed = (x - from_x) - (c - (from_x - difference));  // Knuth's TwoSum of x and -c
  const bool is_even = (std::bit_cast<std::uint64_t>(difference) & 1) == 0;
  if (missed == 0 || !is_even) return difference;
  return std::nextafter(difference, missed > 0 ? HUGE_VAL : -HUGE_VAL);
}

double RoundToFloat32(double x) {
  return std::fabs(x) >= 0x1p127 ? x : static_cast<double>(static_cast<float>(x));
}

// Whether |a - b| > most, though the difference rounds: rounding keeps the order, and if it gives
// `most` itself, the rounding error (Knuth's TwoSum, exact without overflow) decides by its sign.
bool LieFurtherApart(double a, double b, double most) {
  const double difference = a - b;
  if (std::fabs(difference) != most) return std::fabs(difference) > most;
  const double from_a = difference + b;
  const double missed = (a - from_a) - (b - (from_a - difference));
  return difference > 0 ? missed > 0 : missed < 0;
}

}  // namespace

double SnapCoordinate(double x, const Snap& snap) {
  if (snap.IsNone() || !std::isfinite(x)) return x;
  if (snap.form == SnapForm::kCoordinate) return SnapToMultiple(x, snap.bits, snap.rule);
  const double difference = DifferenceToOdd(x, snap.origin);
  const double rounded =
      snap.form == SnapForm::kFloat32Difference ? RoundToFloat32(difference) : difference;
  return snap.origin + SnapToMultiple(rounded, snap.bits, snap.rule);
}

std::vector<double> GridPointsWithin(double x, const Snap& snap, double tolerance) {
  constexpr double kCoarseFrom = 0x1p36;  // beyond, a step may be less than an ulp
  const double own = SnapCoordinate(x, snap);
  if (snap.IsNone() || !(std::fabs(x) < kCoarseFrom)) return {own};
  Snap below = snap;
  below.rule = SnapRule::kFloor;
  if (below.form == SnapForm::kFloat32Difference) below.form = SnapForm::kExactDifference;
  const double step = std::ldexp(1.0, -snap.bits);
  const double first = SnapCoordinate(x, below);
  std::vector<double> points{own};  // a float32 difference may have taken it far from x
  for (int k = -1; k <= 2; ++k) {
    const double point = first + k * step;
    if (point != own && !LieFurtherApart(point, x, tolerance * step)) points.push_back(point);
  }
  std::ranges::sort(points);
  return points;
}

namespace {

bool IsGridPoint(double x, Snap grid) {
  grid.rule = SnapRule::kFloor;
  if (grid.form == SnapForm::kFloat32Difference) grid.form = SnapForm::kExactDifference;
  return SnapCoordinate(x, grid) == x;
}

}  // namespace

std::vector<Snap> LegalGrids(const Snap& snap, const Freedom& freedom) {
  if (snap.IsNone() || !freedom.least_bits) return {snap};
  std::vector<Snap> grids;
  for (int bits = *freedom.least_bits; bits <= kMaxSubpixelBits; ++bits) {
    grids.push_back(snap);
    grids.back().bits = bits;
  }
  grids.push_back({});
  return grids;
}

std::vector<double> LegalGridPoints(double x, const Snap& grid, const Freedom& freedom) {
  std::vector<double> points = GridPointsWithin(x, grid, freedom.snap_tolerance);
  if (!freedom.any_rounding || IsGridPoint(x, grid)) return points;
  for (const double point : GridPointsWithin(x, grid, 1)) {
    if (std::ranges::find(points, point) == points.end()) points.push_back(point);
  }
  std::ranges::sort(points);
  return points;
}

}  // namespace rasterproof
