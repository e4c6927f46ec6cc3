// Wireframe on a surface in space: a triangle recovered from one shaded point, and its
// barycentrics.
#ifndef RASTERPROOF_REFERENCE_WIREFRAME_H_
#define RASTERPROOF_REFERENCE_WIREFRAME_H_

#include <array>

#include "core/scene.h"

namespace rasterproof::reference {

/// A point or vector in space.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Point3&, const Point3&) = default;
};

/// What a shader knows of the point it shades: P = A + u (B - A) + v (C - A), dPdu = B - A,
/// dPdv = C - A.
struct SurfacePoint {
  Point3 p;
  double u = 0;
  double v = 0;
  Point3 dpdu;
  Point3 dpdv;
};

/// The triangle's vertices: A = (P - u dPdu) - v dPdv, B = A + dPdu, C = A + dPdv.
///
/// Precondition of the renderer: its u, v belong to that parametrisation. Then the barycentrics of
/// P are 1 - u - v at A, u at B, v at C.
/// Error:      rounded once an operation in the precision; see ReconstructionErrorBounds.
std::array<Point3, 3> ReconstructVertices(Precision precision, const SurfacePoint& point);

/// Proven bounds, entry by entry, on the distance of each coordinate from the exact one; NaN where
/// none is stated (overflow, or an input that is not of the precision).
///
/// Measured:   largest error / bound 0.990 (float32), 0.999 (float64): MeasuredReferenceBounds,
///             10000 inputs each, climbing from seeds 75 and 76, 2026-11-23.
std::array<Point3, 3> ReconstructionErrorBounds(Precision precision, const SurfacePoint& point);

/// Unsigned barycentrics of p in the plane of a triangle in space: entries 0 and 2 are the lengths
/// of cross products over that of the whole, entry 1 is what is left of 1; entry i belongs to
/// vertex i.
///
/// Domain:     p in the closed triangle. Outside it a length has lost its sign, and the
/// barycentrics
///             can look like those of an inside point: A = (0,0), B = (4,0), C = (0,4), p = (2,-1)
///             has barycentrics (3/4, 1/2, -1/4) and is given (3/4, 0, 1/4).
/// Returns:    NaN or infinities for a triangle of zero area.
std::array<double, 3> UnsignedBarycentrics(Precision precision, const std::array<Point3, 3>& v,
                                           Point3 p);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_WIREFRAME_H_
