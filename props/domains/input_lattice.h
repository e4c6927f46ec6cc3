// The numbers that a subject's coordinates can be.
#ifndef RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_
#define RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_

#include <cstdint>

#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"

namespace rasterproof::props {

/// The places that a coordinate can take without being rounded again: floats of one precision, on
/// the subpixel grid of the profile if it has one.
///
/// "One step" is the distance between neighbouring places: an ulp, or a subpixel, whichever is the
/// larger. Recipes that put a vertex "one step off" an edge mean this step.
class InputLattice {
 public:
  InputLattice(const Profile& profile, Precision precision);

  Precision precision() const { return precision_; }
  /// The largest lattice place within the profile's coordinate limit.
  double limit() const { return limit_; }
  /// Significant bits of the precision: 24 or 53.
  int digits() const { return precision_ == Precision::kFloat32 ? 24 : 53; }

  /// The lattice place nearest to x.
  ///
  /// Domain:     any double. NaN and infinities are returned as they are; what would overflow
  ///             becomes the largest finite place.
  double Round(double x) const;
  /// Round(x) taken back within +-limit().
  double RoundWithinLimit(double x) const;
  /// The nearest value of the precision, on or off the subpixel grid.
  double RoundToPrecision(double x) const;
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
  double limit_ = 0;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_INPUT_LATTICE_H_
