// Edges cut to what a picture shows.
#ifndef RASTERPROOF_REPORT_VIEW_GEOMETRY_H_
#define RASTERPROOF_REPORT_VIEW_GEOMETRY_H_

#include <array>
#include <optional>

#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::report {

/// What is shown of the window.
///
/// Units:      window pixels; x0 < x1, y0 < y1, all of ordinary size.
struct ViewBox {
  double x0 = 0;
  double y0 = 0;
  double x1 = 1;
  double y1 = 1;
};

/// The part of the segment a, b within the box, if there is any.
///
/// Domain:     every finite double.
/// Error:      a few 2^-53 of the box's place and size, however far away the ends are: good for the
///             eye, no verdict rests on it.
std::optional<std::array<Point2, 2>> ClipSegment(Point2 a, Point2 b, const ViewBox& box);

/// The corners of a triangle as they lie in the window; nothing if one of them does not.
std::optional<std::array<Point2, 3>> WindowCorners(const Scene& scene, int triangle);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_VIEW_GEOMETRY_H_
