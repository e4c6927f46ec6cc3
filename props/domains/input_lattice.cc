#include "props/domains/input_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/ulp.h"

namespace rasterproof::props {

InputLattice::InputLattice(const Profile& profile, Precision precision)
    : precision_(precision), grid_(profile.snap) {
  // The grid's points, whatever the rule and the rounding that lead to them.
  grid_.rule = SnapRule::kNearestEven;
  if (grid_.form != SnapForm::kCoordinate) grid_.form = SnapForm::kExactDifference;
  const double promised = std::fabs(profile.coordinate_limit);
  limit_ = Round(std::isnan(promised) ? 0 : std::min(promised, std::numeric_limits<double>::max()));
  if (limit_ > promised) limit_ = Move(limit_, -1);
}

double InputLattice::RoundToPrecision(double x) const {
  if (precision_ == Precision::kFloat64 || !std::isfinite(x)) return x;
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -kLargest, kLargest));
}

double InputLattice::Round(double x) const {
  // A float that is too large to have the grid's last bit is a multiple of the grid all the same,
  // so rounding to the grid first and to the precision second ends on both.
  return RoundToPrecision(SnapCoordinate(x, grid_));
}

double InputLattice::RoundWithinLimit(double x) const {
  return std::clamp(Round(x), -limit_, limit_);
}

double InputLattice::Step(double x) const {
  const double magnitude = std::fabs(x);
  const int least = precision_ == Precision::kFloat32 ? -149 : -1074;
  const int ulp = magnitude == 0 ? least : std::max(least, std::ilogb(magnitude) - (digits() - 1));
  return std::ldexp(1.0, grid_.IsNone() ? ulp : std::max(ulp, -grid_.bits));
}

double InputLattice::Move(double x, std::int64_t n) const {
  if (!std::isfinite(x)) return x;
  if (!grid_.IsNone()) return Round(x + static_cast<double>(n) * Step(x));
  if (precision_ == Precision::kFloat64) return MoveByUlps(x, n);
  return MoveByUlps(static_cast<float>(x), n);
}

int InputLattice::GridBits(double reach) const {
  const int bits = digits() - std::ilogb(reach);
  return grid_.IsNone() ? bits : std::min(bits, grid_.bits);
}

}  // namespace rasterproof::props
