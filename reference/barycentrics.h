// Barycentrics, interpolation and wireframe of the reference, in float32 and float64.
#ifndef RASTERPROOF_REFERENCE_BARYCENTRICS_H_
#define RASTERPROOF_REFERENCE_BARYCENTRICS_H_

#include <array>

#include "core/evaluators.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"

namespace rasterproof::reference {

/// The reference's barycentric evaluator in the arithmetic of `precision`, with its proven bounds.
///
/// Edge values are the direct form's; every operation is rounded once to the precision. Where the
/// computed area (or, for kSum, the computed sum) is 0 or not finite the barycentrics are NaN or
/// infinite, as IEEE division gives them, and no bound is stated.
///
/// Error:      every bound is a running bound: the error of each operation is bounded from the
///             values computed, rounded up, and grown by the rules of reference/running_error.h.
///             kUnsignedArea: NaN where the sample is proved to lie outside the triangle, where the
///             form is wrong. kPerspective: NaN where the denominator may be 0.
/// Measured:   largest error / bound known of a barycentric 1.0000 (f32-direct), 1.0000
///             (f32-kahan), 1.0000 (f64-direct); of their sum 1.0000 (f32-direct), 1.0000
///             (f64-direct); of an interpolated value 0.9999 (f32-direct), with perspective 0.5646
///             (f32-direct): scenes/worst/README.md.
const BarycentricEvaluator& ReferenceBarycentrics(Precision precision);

/// |l0 + l1 + l2 - 1| <= multiplier u + 3 eta / 2 for kSum where the three edge values agree in
/// sign.
///
/// Relative errors give 3u: two roundings of the sum, one of the quotients. They are not all that
/// large at once. With s in [1, 2) each sum rounds by at most u. Three quotients round by half an
/// ulp each: u / 2 from one half on, u / 4 from one quarter on, and what is less by u of itself.
/// Where only one quotient is at least one half and e0 + e1 is at least 1, that is 2u + u / 2 +
/// u / 4; a third quotient q makes 1 / s smaller by as much as it adds, or more. In the other cases
/// it is at most 5u / 2. Proof: docs/mathematics.md, 9, and proofs/barycentrics_sum.g.
/// Measured:   largest error / bound known above 0.9999: docs/mathematics.md, 9, has the witnesses.
template <class T>
inline constexpr double kNormalizedSumErrorMultiplier = 2.75 + 4.0 * rounding_epsilon<T>();

/// |l0 + l1 + l2 - 1| <= kOneMinusSumError for kOneMinus inside the triangle.
///
/// 1 - l0 and then l2 itself lie in [0, 1]: each rounding is at most u / 2.
/// Proof: proofs/barycentrics_one_minus.g. The float sum fl(fl(l0 + l1) + l2) is 1 or 1 - u, the
/// number below: docs/mathematics.md, 9.
/// Measured:   1 u in both precisions, as above: the bound is reached.
template <class T>
inline constexpr double kOneMinusSumError = rounding_epsilon<T>();

/// kDerivative and kHeight divide by the area and multiply by it again; it cancels but for three
/// roundings: the barycentric, the height (or derivative), their product (or quotient).
/// Proof: proofs/barycentrics_distance.g.
/// Measured:   largest error / bound of a distance known above 0.998, as above.
template <class T>
inline constexpr double kEdgeDistanceErrorMultiplier = 3 + 4.0 * rounding_epsilon<T>();

/// Proven bounds on |EdgeDistances[i] - exact|: kBarycentric against lambda_i, kDerivative against
/// sign(area) E_i / (|dX_i| + |dY_i|), kHeight against sign(area) E_i / sqrt(dX_i^2 + dY_i^2).
///
/// Returns:    NaN where none is stated: over- or underflow, area not provably non-zero.
std::array<double, 3> EdgeDistanceErrorBounds(Precision precision, WireframeForm form,
                                              const std::array<Point2, 3>& v, Point2 p);

/// The height of the triangle over each side: entry i is the distance of vertex i from the side
/// opposite to it, |area| / |side i|.
///
/// Units:      pixels. Rounded in the precision.
std::array<double, 3> Heights(Precision precision, const std::array<Point2, 3>& v);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_BARYCENTRICS_H_
