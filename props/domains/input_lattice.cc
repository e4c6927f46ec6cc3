#include "props/domains/input_lattice.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/ulp.h"
#include "model/snap.h"

namespace rasterproof::props {

namespace {

// A format that wraps is given coordinates of three spans beyond either end of its range.
double SpanBeyond(const FixedInput& fixed) { return fixed.wraps ? 3 * fixed.Span() : 0; }

// Whether every point of the grid is a multiple of the format's step.
bool HoldsGrid(const FixedInput& fixed, const Snap& grid) {
  if (grid.IsNone() || grid.bits > fixed.fraction_bits) return false;
  if (grid.form == SnapForm::kCoordinate) return true;
  const double origin = std::ldexp(grid.origin, fixed.fraction_bits);
  return origin == std::floor(origin);
}

}  // namespace

Precision PrecisionOf(const FixedInput& fixed) {
  const int bits = fixed.integer_bits + fixed.fraction_bits + (fixed.wraps ? 2 : 0);
  return bits <= 24 ? Precision::kFloat32 : Precision::kFloat64;
}

InputLattice::InputLattice(const Profile& profile, Precision precision)
    : precision_(precision), grid_(profile.snap), fixed_(profile.fixed) {
  if (fixed_) {
    if (!HoldsGrid(*fixed_, grid_)) grid_ = {fixed_->fraction_bits};
    const double beyond = SpanBeyond(*fixed_);
    const double step = std::ldexp(1.0, -grid_.bits);
    first_ = SnapCoordinate(fixed_->Least() - beyond, grid_);
    if (first_ < fixed_->Least() - beyond) first_ += step;
    last_ = SnapCoordinate(fixed_->Largest() + beyond, grid_);
    if (last_ > fixed_->Largest() + beyond) last_ -= step;
  }
  // The grid's points, whatever the rule and the rounding that lead to them.
  grid_.rule = SnapRule::kNearestEven;
  if (grid_.form != SnapForm::kCoordinate) grid_.form = SnapForm::kExactDifference;
  const double stated = std::fabs(profile.coordinate_limit);
  limit_ = Round(std::isnan(stated) ? 0 : std::min(stated, std::numeric_limits<double>::max()));
  if (limit_ > stated) limit_ = Move(limit_, -1);
  lowest_ = -limit_;
  if (!fixed_) return;
  const double greatest = std::min(stated, fixed_->Largest());
  const double least = std::max(-stated, fixed_->Least());
  limit_ = Round(greatest);
  if (limit_ > greatest) limit_ = Move(limit_, -1);
  lowest_ = Round(least);
  if (lowest_ < least) lowest_ = Move(lowest_, 1);
}

double InputLattice::RoundToPrecision(double x) const {
  if (!fixed_ || !std::isfinite(x)) return RoundToFloat(x);
  const double beyond = SpanBeyond(*fixed_);
  const double given = SnapCoordinate(x, {fixed_->fraction_bits});
  return std::clamp(given, fixed_->Least() - beyond, fixed_->Largest() + beyond);
}

double InputLattice::RoundToFloat(double x) const {
  if (precision_ == Precision::kFloat64 || !std::isfinite(x)) return x;
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -kLargest, kLargest));
}

double InputLattice::Round(double x) const {
  // A float that is too large to have the grid's last bit is a multiple of the grid all the same,
  // so rounding to the grid first and to the precision second ends on both.
  const double on_grid = SnapCoordinate(x, grid_);
  return fixed_ && std::isfinite(x) ? std::clamp(on_grid, first_, last_)
                                    : RoundToPrecision(on_grid);
}

double InputLattice::RoundWithinLimit(double x) const {
  return std::clamp(Round(x), lowest_, limit_);
}

double InputLattice::Step(double x) const {
  // By the bits, for it is called for each sample near an edge. An exponent of 0 is that of 0 and
  // of subnormals, whose step is the least.
  constexpr int kMantissaBits = 52;
  constexpr int kBias = 1023;
  const auto exponent =
      static_cast<int>(std::bit_cast<std::uint64_t>(std::fabs(x)) >> kMantissaBits);
  const int least = precision_ == Precision::kFloat32 ? -149 : -1074;
  const int ulp = exponent == 0 ? least : std::max(least, exponent - kBias - (digits() - 1));
  const int step = grid_.IsNone() ? ulp : std::max(ulp, -grid_.bits);
  if (step <= -kBias) return std::ldexp(1.0, step);
  return std::bit_cast<double>(static_cast<std::uint64_t>(step + kBias) << kMantissaBits);
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
