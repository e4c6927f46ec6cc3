#include "exact/half_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"

namespace rasterproof::exact {
namespace {

struct RationalPoint {
  Rational x;
  Rational y;
};

Rational ValueAt(const HalfPlane& plane, const RationalPoint& p) {
  return plane.a * p.x + plane.b * p.y + plane.c;
}

// E(a, b; p) as a x + b y + c.
HalfPlane EdgeFunction(Point2 a, Point2 b) {
  const Rational dx = Rational(b.x) - Rational(a.x);
  const Rational dy = Rational(b.y) - Rational(a.y);
  return {dy, -dx, Rational(a.y) * dx - Rational(a.x) * dy};
}

HalfPlane Scaled(const HalfPlane& plane, const Rational& factor) {
  return {plane.a * factor, plane.b * factor, plane.c * factor};
}

bool IsAnEdgeOfTheHull(Point2 a, Point2 b, const std::vector<Point2>& points) {
  return !(a == b) && std::ranges::all_of(points, [&](Point2 p) { return EdgeSign(a, b, p) >= 0; });
}

// Where the segment crosses the line. Its ends have values of opposite signs.
RationalPoint Crossing(const RationalPoint& from, const Rational& at_from, const RationalPoint& to,
                       const Rational& at_to) {
  const Rational part = at_from / (at_from - at_to);
  return {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
}

// The convex polygon's part in the half plane: Sutherland and Hodgman. A segment and a point count
// as polygons of two corners and of one.
std::vector<RationalPoint> Clipped(const std::vector<RationalPoint>& polygon,
                                   const HalfPlane& plane) {
  std::vector<Rational> values;
  values.reserve(polygon.size());
  for (const RationalPoint& p : polygon) values.push_back(ValueAt(plane, p));
  std::vector<RationalPoint> clipped;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = (k + 1) % polygon.size();
    if (values[k].Sign() >= 0) clipped.push_back(polygon[k]);
    if (values[k].Sign() * values[next].Sign() < 0)
      clipped.push_back(Crossing(polygon[k], values[k], polygon[next], values[next]));
  }
  return clipped;
}

}  // namespace

std::vector<HalfPlane> HullOf(const std::vector<Point2>& points) {
  std::vector<std::pair<Point2, Point2>> edges;
  for (const Point2 a : points) {
    for (const Point2 b : points) {
      if (!IsAnEdgeOfTheHull(a, b, points)) continue;
      const bool is_known = std::ranges::any_of(edges, [&](const auto& edge) {
        return EdgeSign(edge.first, edge.second, a) == 0 &&
               EdgeSign(edge.first, edge.second, b) == 0;
      });
      if (!is_known) edges.emplace_back(a, b);
    }
  }
  std::vector<HalfPlane> planes;
  planes.reserve(edges.size());
  for (const auto& [a, b] : edges) planes.push_back(EdgeFunction(a, b));
  return planes;
}

std::vector<HalfPlane> WhereBarycentricsAre(const std::array<Point2, 3>& v,
                                            const std::array<Rational, 3>& low,
                                            const std::array<Rational, 3>& high) {
  const Rational one_over_area = Rational(1) / EdgeValue(v[0], v[1], v[2]);
  std::vector<HalfPlane> planes;
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfPlane lambda = Scaled(EdgeFunction(v[(i + 1) % 3], v[(i + 2) % 3]), one_over_area);
    planes.push_back({lambda.a, lambda.b, lambda.c - low[i]});
    planes.push_back({-lambda.a, -lambda.b, high[i] - lambda.c});
  }
  return planes;
}

bool RectangleMeets(Point2 low, Point2 high, const std::vector<HalfPlane>& planes) {
  std::vector<RationalPoint> polygon{
      {low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}};
  for (const HalfPlane& plane : planes) {
    polygon = Clipped(polygon, plane);
    if (polygon.empty()) return false;
  }
  return true;
}

}  // namespace rasterproof::exact
