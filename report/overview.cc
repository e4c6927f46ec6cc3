#include "report/overview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

constexpr double kLeastTimesLarger = 2;
constexpr double kOverviewHeight = 110;  // at most
constexpr double kNarrowest = 4;         // height over width: with less the axes are scaled apart
constexpr double kLeastMark = 6;         // side of what is marked
constexpr double kLabelSize = 10;

ViewBox BoxOf(const std::array<Point2, 3>& corners) {
  ViewBox box{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
  for (const Point2& p : corners) {
    box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x),
           std::max(box.y1, p.y)};
  }
  return box;
}

// Halves, for the difference of two ends can overflow.
double HalfWidth(const ViewBox& box) { return box.x1 / 2 - box.x0 / 2; }
double HalfHeight(const ViewBox& box) { return box.y1 / 2 - box.y0 / 2; }

ViewBox Union(const ViewBox& a, const ViewBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// "1,048,576", "12.5", "3.4e+38".
std::string LengthText(double half) {
  constexpr double kMostDigits = 1e12;
  constexpr double kFewDigits = 1000;
  const double length = 2 * half;
  if (!(length < kMostDigits))
    return std::isinf(length) ? "over 1e308" : fmt::format("{:.3g}", length);
  if (length < kFewDigits) return fmt::format("{:.4g}", length);
  std::string digits = fmt::format("{:.0f}", length);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

}  // namespace

std::optional<Overview> OverviewOf(const Explanation& explanation, const PixelRect& view) {
  const int height = explanation.expected.height;
  const ViewBox shown{static_cast<double>(view.x0), static_cast<double>(view.y0),
                      static_cast<double>(view.x1), static_cast<double>(view.y1)};
  std::optional<Overview> largest;
  double size = 0;
  for (const int triangle : explanation.triangles) {
    if (triangle < 0 || static_cast<std::size_t>(triangle) >= explanation.scene.triangles.size()) {
      continue;
    }
    auto corners = WindowCorners(explanation.scene, triangle);
    if (!corners) continue;
    for (Point2& p : *corners) {
      if (explanation.y_axis == YAxis::kUp) p.y = height - p.y;
    }
    const ViewBox box = BoxOf(*corners);
    const bool is_larger = HalfWidth(box) > kLeastTimesLarger * HalfWidth(shown) ||
                           HalfHeight(box) > kLeastTimesLarger * HalfHeight(shown);
    const double here = std::max(HalfWidth(box), HalfHeight(box));
    if (!is_larger || !(here > size)) continue;
    size = here;
    const double width = explanation.expected.width;
    largest = Overview{triangle, *corners, box, {0, 0, width, static_cast<double>(height)}, shown};
  }
  return largest;
}

std::string OverviewText(const Overview& overview) {
  const ViewBox& shown = overview.shown;
  return fmt::format(
      "triangle {} is {} x {} pixels; shown: columns {:.0f}..{:.0f}, rows {:.0f}..{:.0f}",
      overview.triangle, LengthText(HalfWidth(overview.triangle_box)),
      LengthText(HalfHeight(overview.triangle_box)), shown.x0, shown.x1 - 1, shown.y0,
      shown.y1 - 1);
}

double DrawOverview(const Overview& overview, Point2 top_left, double width, Figure& figure) {
  const ViewBox all = Union(overview.triangle_box, overview.target);
  const double room = std::max(HalfWidth(all), HalfHeight(all));  // > 0: the target has pixels
  double wide = width * (HalfWidth(all) / room);
  double high = width * (HalfHeight(all) / room);
  if (high > kOverviewHeight) {
    wide *= kOverviewHeight / high;
    high = kOverviewHeight;
  }
  high = std::max(high, kOverviewHeight / kNarrowest);
  wide = std::max(wide, kOverviewHeight / kNarrowest);
  const auto on_paper = [&](Point2 p) {
    return Point2{top_left.x + wide * ((p.x / 2 - all.x0 / 2) / HalfWidth(all)),
                  top_left.y + high * ((p.y / 2 - all.y0 / 2) / HalfHeight(all))};
  };
  std::vector<Point2> outline;
  for (const Point2& p : overview.corners) outline.push_back(on_paper(p));
  figure.Polygon(outline, kCovered);
  for (std::size_t k = 0; k < 3; ++k) figure.Line(outline[k], outline[(k + 1) % 3], kInk, 1, 0.9);
  // What is too small to be seen is marked around its middle.
  const auto frame = [&](const ViewBox& box, double least, Colour colour, double line) {
    const Point2 low = on_paper({box.x0, box.y0});
    const Point2 high_corner = on_paper({box.x1, box.y1});
    const Point2 middle{(low.x + high_corner.x) / 2, (low.y + high_corner.y) / 2};
    const double x = std::max(high_corner.x - low.x, least) / 2;
    const double y = std::max(high_corner.y - low.y, least) / 2;
    figure.Frame(middle.x - x, middle.y - y, middle.x + x, middle.y + y, colour, line);
  };
  frame(overview.target, 2 * kLeastMark, kFaintInk, 1.5);
  frame(overview.shown, kLeastMark, kInk, 3);
  frame(overview.shown, kLeastMark, kYellow, 1.5);
  const double below = top_left.y + high + 2 * kLabelSize;
  const bool is_apart = std::fabs(wide / HalfWidth(all) * HalfHeight(all) / high - 1) > 0.01;
  figure.Text({top_left.x, below},
              std::string("the whole triangle; grey: the target, yellow: what is shown above") +
                  (is_apart ? "; x and y are scaled apart" : ""),
              kFaintInk, kLabelSize);
  return high + 3.5 * kLabelSize;
}

}  // namespace rasterproof::report
