// Box and scissor: which pixels a triangle can touch at all.
#ifndef RASTERPROOF_REFERENCE_BOX_H_
#define RASTERPROOF_REFERENCE_BOX_H_

#include <array>
#include <optional>

#include "core/draw_options.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "reference/method.h"

namespace rasterproof::reference {

/// Returns the smallest n in [low, high] whose centre n + 1/2 is at or beyond x; high if none is.
///
/// Domain:     any x, NaN included (returns low); 0 <= low <= high <= kMaxTargetSide.
/// Error:      none: no float is converted before it is known to lie in [low, high].
int FirstCentreFrom(double x, int low, int high);

/// Returns the smallest n in [low, high] whose centre n + 1/2 is strictly beyond x; high if none.
int FirstCentreBeyond(double x, int low, int high);

/// The whole target, and the part of it that the scissor leaves (possibly empty: x0 >= x1).
PixelRect TargetOf(const Scene& scene);
PixelRect DrawArea(const Scene& scene, const DrawOptions& options);

PixelRect Intersection(const PixelRect& a, const PixelRect& b);
inline bool IsEmpty(const PixelRect& r) { return r.x0 >= r.x1 || r.y0 >= r.y1; }

/// Returns the pixels of `area` whose centres lie in the closed bounding box of the points.
///
/// Properties: no sample that the closed triangle contains is left out; none outside the points'
///             extent is taken in, so what a kernel evaluates stays within that extent.
PixelRect SampleBox(const std::array<Point2, 3>& v, const PixelRect& area);

/// The place stage of a method that draws vertices where they are given: nothing unless all are
/// finite. The box stage of a window-space method.
std::optional<Corners3> PlaceAsGiven(const Corners3& given);
PixelRect BoxOfCorners(const Corners3& v, const PixelRect& target);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_BOX_H_
