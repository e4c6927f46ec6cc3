// Snapping of clip-space vertices: after the division, and without its rounding.
#ifndef RASTERPROOF_EXACT_SNAP_CLIP_H_
#define RASTERPROOF_EXACT_SNAP_CLIP_H_

#include <array>
#include <optional>

#include "core/error.h"
#include "core/scene.h"
#include "core/snap.h"
#include "core/vertex.h"
#include "model/target_profile.h"

namespace rasterproof::exact {

/// Returns the grid point of `snap` that the rational x / w rounds to.
///
/// Domain:     finite; w > 0; a snap (not kNone) of the form kCoordinate; |x / w| < 2^(50 - bits).
/// Error:      none: the quotient is never rounded on its way to the grid. InputError outside.
double SnapQuotient(double x, double w, const Snap& snap);

/// Returns SnapQuotient() within its domain, else nothing.
std::optional<double> TrySnapQuotient(double x, double w, const Snap& snap);

/// Returns the facing of the triangle of snapped vertices: +1 front, -1 back, 0 no area. Nothing if
/// one of them has no place on the grid.
///
/// Domain:     clip space.
std::optional<int> SnappedClipFacing(const std::array<Vertex, 3>& v, const Snap& snap);

/// Returns why the vertices of a clip-space scene have no places on the profile's grid: a finite
/// triangle has a w <= 0 or a quotient beyond SnapQuotient's domain, or the profile snaps
/// differences of window coordinates. Nothing if they have places.
///
/// Domain:     clip space, a profile that snaps.
std::optional<InputError> SnapClipError(const Scene& scene, const TargetProfile& profile);

/// Returns the window-space scene of the snapped vertices.
///
/// Domain:     clip space, a profile that snaps.
/// Error:      SnapClipError().
Scene SnapClipScene(const Scene& scene, const TargetProfile& profile);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SNAP_CLIP_H_
