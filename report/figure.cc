#include "report/figure.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Hex(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

// 1/100 of a pixel is finer than anyone sees.
std::string Decimal(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Opacity(const Shape& shape, std::string_view attribute) {
  return shape.opacity < 1 ? fmt::format(" {}=\"{}\"", attribute, Decimal(shape.opacity)) : "";
}

std::string PolygonElement(const Shape& shape) {
  std::string points;
  for (const Point2& p : shape.points) points += fmt::format("{},{} ", Decimal(p.x), Decimal(p.y));
  if (!points.empty()) points.pop_back();
  return fmt::format("<polygon points=\"{}\" fill=\"{}\"{}/>", points, Hex(shape.colour),
                     Opacity(shape, "fill-opacity"));
}

std::string Element(const Shape& shape) {
  const Point2 p = shape.points.front();
  switch (shape.kind) {
    case ShapeKind::kPolygon:
      return PolygonElement(shape);
    case ShapeKind::kLine:
      return fmt::format(
          "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>",
          Decimal(p.x), Decimal(p.y), Decimal(shape.points[1].x), Decimal(shape.points[1].y),
          Hex(shape.colour), Decimal(shape.size), Opacity(shape, "stroke-opacity"));
    case ShapeKind::kDot:
      return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>", Decimal(p.x),
                         Decimal(p.y), Decimal(shape.size), Hex(shape.colour));
    case ShapeKind::kText:
      return fmt::format(
          "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" xml:space=\"preserve\">{}</text>",
          Decimal(p.x), Decimal(p.y), Decimal(shape.size), Hex(shape.colour), Escaped(shape.text));
  }
  return {};
}

}  // namespace

Colour Mix(Colour a, Colour b, double t) {
  Colour mixed;
  for (std::size_t k = 0; k < 3; ++k) {
    mixed[k] = static_cast<std::uint8_t>(std::lround(a[k] + t * (b[k] - a[k])));
  }
  return mixed;
}

void Figure::Polygon(std::vector<Point2> outline, Colour colour, double opacity) {
  if (outline.size() < 3) return;
  shapes.push_back({ShapeKind::kPolygon, std::move(outline), colour, opacity, 1, {}});
}

void Figure::Rectangle(double x0, double y0, double x1, double y1, Colour colour) {
  Polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, colour);
}

void Figure::Frame(double x0, double y0, double x1, double y1, Colour colour, double line_width) {
  const double out = line_width / 2;
  Line({x0 - out, y0}, {x1 + out, y0}, colour, line_width);
  Line({x0 - out, y1}, {x1 + out, y1}, colour, line_width);
  Line({x0, y0}, {x0, y1}, colour, line_width);
  Line({x1, y0}, {x1, y1}, colour, line_width);
}

void Figure::Line(Point2 a, Point2 b, Colour colour, double line_width, double opacity) {
  shapes.push_back({ShapeKind::kLine, {a, b}, colour, opacity, line_width, {}});
}

void Figure::Dot(Point2 centre, double radius, Colour colour) {
  shapes.push_back({ShapeKind::kDot, {centre}, colour, 1, radius, {}});
}

void Figure::Text(Point2 baseline, std::string_view text, Colour colour, double size) {
  shapes.push_back({ShapeKind::kText, {baseline}, colour, 1, size, std::string(text)});
}

void Figure::CentredText(Point2 centre, std::string_view text, Colour colour, double size) {
  const double half = kAdvance * size * static_cast<double>(text.size()) / 2;
  Text({centre.x - half, centre.y + 0.35 * size}, text, colour, size);
}

std::string FigureToSvg(const Figure& figure) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\">\n",
      Decimal(figure.width), Decimal(figure.height));
  svg += fmt::format("<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", Hex(kPaper));
  for (const Shape& shape : figure.shapes) svg += Element(shape) + '\n';
  return svg + "</svg>\n";
}

}  // namespace rasterproof::report
