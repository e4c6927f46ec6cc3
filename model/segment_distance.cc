#include "model/segment_distance.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace rasterproof {
namespace {

// a b - c d, off by at most 1.5 ulps (Jeannerod, Louvet, Muller 2013).
double DifferenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

}  // namespace

double SegmentDistance(Point2 a, Point2 b, Point2 p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double px = p.x - a.x;
  const double py = p.y - a.y;
  const double along = px * dx + py * dy;
  const double length_2 = dx * dx + dy * dy;
  if (along <= 0 || length_2 == 0) return Hypot(px, py);
  if (along >= length_2) return Hypot(p.x - b.x, p.y - b.y);
  return std::abs(DifferenceOfProducts(px, dy, py, dx)) / std::sqrt(length_2);
}

double BoundaryDistance(const std::array<Point2, 3>& v, Point2 p) {
  return std::min({SegmentDistance(v[0], v[1], p), SegmentDistance(v[1], v[2], p),
                   SegmentDistance(v[2], v[0], p)});
}

}  // namespace rasterproof
