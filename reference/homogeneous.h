// Methods that take clip space: edges of (x, y, w) vertices, most of them without a division.
#ifndef RASTERPROOF_REFERENCE_HOMOGENEOUS_H_
#define RASTERPROOF_REFERENCE_HOMOGENEOUS_H_

#include <span>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "reference/method.h"

namespace rasterproof::reference {

/// The homogeneous rows of the table: hom-projected-f32, hom-scaled-f32, hom-f32, hom-f64,
/// hom-exact.
///
/// With N_ij = V_j x V_i over (x, y, w), N_ij . (p.x, p.y, 1) = w_i w_j E(a, b; p) is defined at
/// w = 0 and changes sign with w_i w_j. Together with the facing -sign det(V0, V1, V2) its sign
/// says which rays (t > 0) through a sample meet the triangle, vertices behind the eye or not.
/// Source:     Olano, Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997.
/// Properties: N_ji = -N_ij bit by bit, so neighbours decide a shared edge alike: no gap, no
///             overlap along it.
std::span<const Method> HomogeneousMethods();

/// |computed - exact| <= multiplier u T for N_ij . (p, 1), T = (|y_j w_i| + |w_j y_i|) |p.x| +
/// (|w_j x_i| + |x_j w_i|) |p.y| + |x_j y_i| + |y_j x_i|; the same for det(V0, V1, V2).
///
/// A term carries its product, the difference, the product with p and two sums: five roundings,
/// (1 + u)^5 - 1 <= (5 + 11u) u. Proof: proofs/homogeneous.g. 16u: a double next to 5 is a multiple
/// of 8u of float64, and 11u would be rounded down.
/// Measured:   largest error / bound known above 0.999: docs/mathematics.md, 9, has the witnesses.
template <class T>
inline constexpr double kHomogeneousErrorMultiplier = 5 + 16.0 * rounding_epsilon<T>();

/// Adds the exact homogeneous coverage of the scene to `counts`: the counts of the profile's
/// canonical model, for any tie rule, sample pattern and y axis.
///
/// Domain:     finite or not, any w (window-space vertices have w = 1); the profile's snap is not
///             applied. Counts of the scene's size and the profile's samples.
/// Error:      none: a filter in double, then exact integers.
void DrawHomogeneousExact(const Scene& scene, const Profile& profile, const DrawOptions& options,
                          CoverageCounts& counts);

/// The exact sign of N_ij . (p.x, p.y, 1); and of w_i w_j E of the projected edge.
///
/// Domain:     finite.
int ExactHomogeneousSign(const Vertex& vi, const Vertex& vj, Point2 p);

/// The exact sign of -det(V0, V1, V2): +1 front, -1 back, 0 covers nothing.
///
/// Domain:     finite.
int ExactHomogeneousFacing(const Vertex& v0, const Vertex& v1, const Vertex& v2);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_HOMOGENEOUS_H_
