// A figure as a list of shapes, and the two ways to show it.
#ifndef RASTERPROOF_REPORT_FIGURE_H_
#define RASTERPROOF_REPORT_FIGURE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/vertex.h"
#include "io/image.h"
#include "report/palette.h"

namespace rasterproof::report {

enum class ShapeKind : std::uint8_t { kPolygon, kLine, kDot, kText };

/// One shape. Later shapes lie over earlier ones.
///
/// Units:      the figure's, x right, y down.
struct Shape {
  ShapeKind kind = ShapeKind::kPolygon;
  std::vector<Point2> points;  ///< a convex outline; two ends; a centre; where the baseline begins
  Colour colour = kInk;
  double opacity = 1;
  double size = 1;  ///< width of a line, radius of a dot, height of a text's line
  std::string text;
};

/// What a picture is made of.
struct Figure {
  double width = 0;
  double height = 0;
  std::vector<Shape> shapes;

  void Polygon(std::vector<Point2> outline, Colour colour, double opacity = 1);
  void Rectangle(double x0, double y0, double x1, double y1, Colour colour);
  void Frame(double x0, double y0, double x1, double y1, Colour colour, double line_width);
  void Line(Point2 a, Point2 b, Colour colour, double line_width, double opacity = 1);
  void Dot(Point2 centre, double radius, Colour colour);
  void Text(Point2 baseline, std::string_view text, Colour colour, double size);
  void CentredText(Point2 centre, std::string_view text, Colour colour, double size);
};

/// A character's advance in a text of size 1: every text is monospaced.
inline constexpr double kAdvance = 0.6;

std::string FigureToSvg(const Figure& figure);

/// The figure with `scale` pixels to its unit, edges smoothed. Characters outside ASCII show as
/// "?".
io::Image FigureToImage(const Figure& figure, double scale);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_FIGURE_H_
