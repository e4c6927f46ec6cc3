// A triangle that is much larger than what a picture shows of it, as a whole.
#ifndef RASTERPROOF_REPORT_OVERVIEW_H_
#define RASTERPROOF_REPORT_OVERVIEW_H_

#include <array>
#include <optional>
#include <string>

#include "core/draw_options.h"
#include "core/vertex.h"
#include "report/figure.h"
#include "report/picture.h"
#include "report/view_geometry.h"

namespace rasterproof::report {

/// The largest of an explanation's triangles, and where it lies.
///
/// Units:      pixels, x right, y down from the target's top.
struct Overview {
  int triangle = 0;
  std::array<Point2, 3> corners;
  ViewBox triangle_box;
  ViewBox target;
  ViewBox shown;
};

/// Returns the overview if a triangle that matters is more than twice as wide or as high as the
/// part of the target that is shown.
///
/// Domain:     triangles whose corners do not lie in the window have none.
std::optional<Overview> OverviewOf(const Explanation& explanation, const PixelRect& view);

/// "triangle 0 is 1,048,576 x 12 pixels; shown: columns 3..42, rows 0..19".
std::string OverviewText(const Overview& overview);

/// Draws the whole triangle into a part of a figure, with the target and the shown part marked,
/// each at least some points large. The axes are scaled apart where one scale for both would leave
/// a line. Returns the height that it takes.
double DrawOverview(const Overview& overview, Point2 top_left, double width, Figure& figure);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_OVERVIEW_H_
