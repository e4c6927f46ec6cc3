// Scenes that tell subpixel grids apart.
#ifndef RASTERPROOF_PROPS_JUDGING_GRID_RULER_H_
#define RASTERPROOF_PROPS_JUDGING_GRID_RULER_H_

#include <vector>

#include "core/scene.h"
#include "model/target_profile.h"

namespace rasterproof::props {

/// Seams on a target, each between two triangles, that tell grids apart, whichever way they round.
///
/// The seam of k bits runs from the top of the target, 2^-k pixels left of a column of samples, to
/// its bottom, 2 2^-k right of it: with k bits or more its ends are grid points, and it crosses the
/// column at a third of the height. With fewer bits its ends move to points left and right of the
/// column, on it, or farther off: it then crosses at half the height, at an end, or nowhere. So a
/// drawing that shows the third refutes all grids of fewer than k bits, and another one all others.
/// A device of b bits is known once the seams of b and of b + 1 bits are drawn.
struct GridRuler {
  Scene seams;               ///< all in one list; their triangles come in pairs
  std::vector<Scene> alone;  ///< one triangle of some seams
};

/// Returns the ruler for targets of this size; its seams are four columns apart, so that narrow
/// targets have few. They are of the profile's bits and one more, then of others from its fewest.
///
/// Domain:     a profile that leaves the number of bits open.
/// Returns:    no triangles where the target is lower than four pixels or narrower than four, or
///             where the profile's input is in fixed point.
GridRuler GridRulerOn(const TargetProfile& profile, int width, int height, Precision precision);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_GRID_RULER_H_
