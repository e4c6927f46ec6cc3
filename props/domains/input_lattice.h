// The values that a subject's coordinates can have.
#ifndef RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_
#define RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_

#include <cstdint>
#include <optional>

#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"

namespace rasterproof::props {

/// The places that a coordinate can take without being rounded again: floats of one precision, on
/// the subpixel grid of the profile if it has one; or the integers of its fixed-point input, on
/// that grid if it is the coarser.
///
/// "One step" is the distance between neighbouring places: an ulp, or a subpixel, whichever is the
/// larger. Recipes that put a vertex "one step off" an edge mean this step.
class InputLattice {
 public:
  /// Domain:     a precision that holds the coordinates of a fixed-point profile (PrecisionOf).
  InputLattice(const Profile& profile, Precision precision);

  Precision precision() const { return precision_; }
  /// The largest lattice place within the profile's coordinate limit.
  double limit() const { return limit_; }
  /// The least one: -limit(), but for the range of a fixed-point input.
  double lowest() const { return lowest_; }
  /// Significant bits of the precision: 24 or 53.
  int digits() const { return precision_ == Precision::kFloat32 ? 24 : 53; }

  /// The lattice place nearest to x.
  ///
  /// Domain:     any double. NaN and infinities are returned unchanged; a value that would overflow
  ///             becomes the largest finite place, and a value that a fixed-point input does not
  ///             take the nearest end of its range (of several adjacent ranges if it wraps).
  double Round(double x) const;
  /// Round(x) taken back within [lowest(), limit()].
  double RoundWithinLimit(double x) const;
  /// The nearest value of the input's number format, on or off the subpixel grid.
  double RoundToPrecision(double x) const;
  /// The nearest value of the scene's precision, for z and w, even if coordinates are integers.
  double RoundToFloat(double x) const;
  /// Distance from the lattice place x to its neighbour away from zero. A power of two.
  double Step(double x) const;
  /// The place n steps from the lattice place x.
  double Move(double x, std::int64_t n) const;
  /// The largest g such that every multiple of 2^-g below `reach` is a lattice place.
  ///
  /// Domain:     reach a power of two.
  int GridBits(double reach) const;

 private:
  Precision precision_;
  Snap grid_;
  std::optional<FixedInput> fixed_;
  double first_ = 0;  ///< of a fixed-point input: the outermost grid places that it is given
  double last_ = 0;
  double limit_ = 0;
  double lowest_ = 0;
};

/// The precision for scenes of a fixed-point input: float32 where it holds every coordinate.
Precision PrecisionOf(const FixedInput& fixed);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_
