#include "report/view_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace rasterproof::report {
namespace {

// The line through a and b as A x + B y = C with (A, B) = (dY, -dX) and C = a.x b.y - a.y b.x: that
// is E = 0 multiplied out. Interpolating from a far end would cancel: a.y + (c - a.x) dY/dX loses
// all digits at a.y = 1e30. Here C is one difference of products, right to two roundings (Kahan's
// fma form; Jeannerod, Louvet, Muller 2013), and the rest is as large as the box.
struct LineEquation {
  double a = 0;
  double b = 0;
  double c = 0;

  LineEquation(Point2 p, Point2 q) {
    // Ends beyond 2^400 are scaled so that products don't overflow.
    constexpr int kLargestExponent = 400;
    const double largest =
        std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y), 1.0});
    const double scale = std::ldexp(1, std::min(0, kLargestExponent - std::ilogb(largest)));
    const Point2 s{p.x * scale, p.y * scale};
    const Point2 t{q.x * scale, q.y * scale};
    a = t.y - s.y;
    b = s.x - t.x;
    const double product = s.y * t.x;
    const double rest = std::fma(-s.y, t.x, product);
    c = (std::fma(s.x, t.y, -product) + rest) / scale;
  }
};

bool IsBetween(double x, double end0, double end1) {
  return std::min(end0, end1) <= x && x <= std::max(end0, end1);
}

// The points where the segment enters or leaves the box, and its ends inside. A crossing that
// rounding puts just outside a corner is pulled in, so that a diagonal through corners is not lost.
std::vector<Point2> PointsOnBox(Point2 p, Point2 q, const ViewBox& box) {
  const LineEquation line(p, q);
  const double slack = 1e-9 * (1 + box.x1 - box.x0 + box.y1 - box.y0);
  std::vector<Point2> points;
  for (const Point2 end : {p, q}) {
    if (IsBetween(end.x, box.x0, box.x1) && IsBetween(end.y, box.y0, box.y1)) {
      points.push_back(end);
    }
  }
  for (const double x : {box.x0, box.x1}) {
    const double y = (line.c - line.a * x) / line.b;
    if (IsBetween(x, p.x, q.x) && IsBetween(y, box.y0 - slack, box.y1 + slack)) {
      points.push_back({x, std::clamp(y, box.y0, box.y1)});
    }
  }
  for (const double y : {box.y0, box.y1}) {
    const double x = (line.c - line.b * y) / line.a;
    if (IsBetween(y, p.y, q.y) && IsBetween(x, box.x0 - slack, box.x1 + slack)) {
      points.push_back({std::clamp(x, box.x0, box.x1), y});
    }
  }
  return points;
}

}  // namespace

std::optional<std::array<Point2, 3>> WindowCorners(const Scene& scene, int triangle) {
  std::array<Point2, 3> window;
  const auto v = Corners(scene, scene.triangles[static_cast<std::size_t>(triangle)]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(v[k].w > 0)) return std::nullopt;
    window[k] = scene.clip_space ? Point2{v[k].x / v[k].w, v[k].y / v[k].w} : WindowPoint(v[k]);
    if (!std::isfinite(window[k].x) || !std::isfinite(window[k].y)) return std::nullopt;
  }
  return window;
}

std::optional<std::array<Point2, 2>> ClipSegment(Point2 a, Point2 b, const ViewBox& box) {
  const std::vector<Point2> points = PointsOnBox(a, b, box);
  std::optional<std::array<Point2, 2>> longest;
  double length = 0;
  for (const Point2 p : points) {
    for (const Point2 q : points) {
      const double distance = std::hypot(p.x - q.x, p.y - q.y);
      if (distance > length) {
        length = distance;
        longest = {p, q};
      }
    }
  }
  return longest;
}

}  // namespace rasterproof::report
