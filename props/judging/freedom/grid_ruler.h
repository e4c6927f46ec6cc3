// Scenes that tell subpixel grids apart.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_GRID_RULER_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_GRID_RULER_H_

#include <vector>

#include "core/scene.h"
#include "model/target_profile.h"

namespace rasterproof::props {

/// Seams on a target, each the left edge of a triangle, that tell grids apart, whichever way they
/// round and whoever owns ties. No second triangle lies beyond a seam: with it every sample would
/// be counted once, on whichever side of the seam it lies.
///
/// A seam of k bits runs along a line of samples, each one column right of the last and three rows
/// below it. Where the line meets whole rows its place is a third of a grid step from the nearest
/// grid point, on every grid: so on no grid does a seam lie on the line, which would leave all its
/// samples to the owner of ties. The seam's upper end is 1/3 of 2^-k left of the line, its lower
/// end 5/3 right of it, both odd multiples of 2^-k. With k bits or more it is drawn so, and crosses
/// the line after 1/6 of its length. With fewer bits each end lies one or two thirds of a coarser
/// step left or right of the line, and the seam crosses it between 1/3 and 2/3 of its length, or
/// not at all. So samples before and after the first sixth tell the two apart, and the seams of b
/// and of b + 1 bits a grid of b bits from all others.
struct GridRuler {
  Scene seams;               ///< all in one list, a triangle each
  std::vector<Scene> alone;  ///< the triangles of some seams
};

/// Returns the ruler for targets of this size, with as many seams as there is room for: of the
/// profile's bits and one more, then of others from its fewest.
///
/// Domain:     a profile that leaves the number of bits open, and states where samples lie.
/// Returns:    no triangles where the target is too small for a seam, or larger than 1024 pixels,
///             or where the profile's input is in fixed point.
GridRuler GridRulerOn(const TargetProfile& profile, int width, int height, Precision precision);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_GRID_RULER_H_
