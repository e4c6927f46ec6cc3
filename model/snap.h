// Snapping of a coordinate: the stage that puts a vertex on the subpixel grid.
#ifndef RASTERPROOF_MODEL_SNAP_H_
#define RASTERPROOF_MODEL_SNAP_H_

#include <vector>

#include "core/freedom.h"
#include "core/snap.h"

namespace rasterproof {

/// Returns the grid point of `snap` that `x` rounds to.
///
/// Domain:     any double; 0 <= snap.bits <= kMaxSubpixelBits, or kNone (returns x itself).
/// Error:      none: the result is the exact grid point that the rule names. (For differences, if
///             |x| < 2^34; beyond, x - c or c + snapped may not be a double, and the result is a
///             neighbour.) Infinity and NaN come back unchanged; the result of a tiny negative x
///             is +0.
double SnapCoordinate(double x, const Snap& snap);

/// Returns the grid points of `snap` at most `tolerance` steps from x, and always the grid point
/// that x rounds to, in ascending order.
///
/// Domain:     as SnapCoordinate, exact where that is; 0 <= tolerance <= 1.
/// Returns:    only the point that x rounds to if the snap is none, x is not finite, or
///             |x| >= 2^36.
std::vector<double> GridPointsWithin(double x, const Snap& snap, double tolerance);

/// Returns the grids of up to kMaxSubpixelBits that the freedom leaves to choose from, coarsest
/// first and no grid last; `snap` alone, unless a least number of bits is stated. Points of finer
/// grids lie between these, coordinate by coordinate.
std::vector<Snap> LegalGrids(const Snap& snap, const Freedom& freedom);

/// Returns the points of one grid that a coordinate may take, in ascending order.
///
/// Domain:     as GridPointsWithin; `grid` is one of LegalGrids.
/// Returns:    the points within the tolerance; if the rounding is not stated, also all points less
///             than a step away.
std::vector<double> LegalGridPoints(double x, const Snap& grid, const Freedom& freedom);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_SNAP_H_
