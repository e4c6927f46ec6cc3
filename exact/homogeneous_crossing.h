// The column at which a row crosses an edge of (x, y, w) vertices, guessed in double.
#ifndef RASTERPROOF_EXACT_HOMOGENEOUS_CROSSING_H_
#define RASTERPROOF_EXACT_HOMOGENEOUS_CROSSING_H_

#include <cmath>
#include <limits>

#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/crossing.h"

namespace rasterproof::exact {

/// Error of the column -(ny y + nw) / nx - offset at which a row crosses, in units of T / |nx| + 1.
///
/// With T = |ny y| + |nw|: the normals are off by 2 u each, the product and the sum round once
/// more, so the numerator is off by at most 4.01 u T; nx by 2 u and the quotient by u, of at most
/// T / |nx| each; less the offset: one more of T / |nx| + 1, and the caller's at +- error as much
/// again. Together below 9.1 u T / |nx| + 2.1 u; 16 leaves room for the five roundings of the
/// bound.
/// Proof:      reference/proofs/homogeneous_crossing.g.
/// Measured:   0.410 of the error is needed, the caller's rounding included: docs/mathematics.md,
///             9, has the witness; 0.321 MeasuredBounds, 60000 inputs climbing from seed 68.
inline constexpr double kHomogeneousCrossingErrorMultiplier = 16 * rounding_epsilon<double>();

/// The zero along a row of N . (x, y, 1), N = V_j x V_i.
///
/// Domain:     finite vertices; At() where N's exact x component is not 0.
class HomogeneousCrossing {
 public:
  HomogeneousCrossing(const Vertex& vi, const Vertex& vj) {
    for (const double c : {vi.x, vi.y, vi.w, vj.x, vj.y, vj.w}) tame_ = tame_ && IsTame(c);
    if (!tame_) return;
    nx_ = ProductDifference(vj.y, vi.w, vj.w, vi.y);
    ny_ = ProductDifference(vj.w, vi.x, vj.x, vi.w);
    nw_ = ProductDifference(vj.x, vi.y, vj.y, vi.x);
  }

  /// Where the row at y crosses, in columns of the samples at column + offset. Nothing is known of
  /// vertices whose products could over- or underflow.
  Guess At(double y, double offset) const {
    if (!tame_) return {0, std::numeric_limits<double>::infinity()};
    const double reach = (std::fabs(ny_ * y) + std::fabs(nw_)) / std::fabs(nx_);
    return {-(ny_ * y + nw_) / nx_ - offset, kHomogeneousCrossingErrorMultiplier * (reach + 1)};
  }

 private:
  // Coordinates in which no product, normal or quotient over- or underflows: products of two in
  // [2^-400, 2^400], their residuals multiples of 2^-506, so normals 0 or in [2^-506, 2^401], and
  // the quotient below 2^(401 + 18 + 506).
  static constexpr double kLeastTame = 0x1p-200;
  static constexpr double kLargestTame = 0x1p200;

  static bool IsTame(double c) {
    const double magnitude = std::fabs(c);
    return magnitude == 0 || (magnitude >= kLeastTame && magnitude <= kLargestTame);
  }
  // a b - c d within 2 u of itself (Kahan's algorithm; Jeannerod, Louvet, Muller 2013), without
  // over- or underflow. So it is 0 only if exactly so.
  static double ProductDifference(double a, double b, double c, double d) {
    const double q = c * d;
    const double q_residual = std::fma(-c, d, q);
    return std::fma(a, b, -q) + q_residual;
  }

  bool tame_ = true;
  double nx_ = 0;
  double ny_ = 0;
  double nw_ = 0;
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_HOMOGENEOUS_CROSSING_H_
