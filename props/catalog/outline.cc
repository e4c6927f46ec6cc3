#include "props/catalog/outline.h"

#include <algorithm>
#include <cmath>

#include "core/scene.h"

namespace rasterproof::props {
namespace {

// How far from the outline a sample must be where the outline is not judged. Edge values of float32
// displace an edge by at most a few 2^-24 of the largest coordinate (docs/mathematics.md, forward
// bounds): 2^-18 of it is generous. A watertight subject may also have moved its vertices by
// snapping them to a grid of its own: a pixel is generous for that.
constexpr double kOutlineMarginPerCoordinate = 0x1p-18;
constexpr double kOutlineMargin = 0x1p-10;
constexpr double kMovedOutlineMargin = 1;

double MarginOf(const Scene& scene, bool may_move) {
  double largest = 0;
  for (const Vertex& v : scene.vertices) {
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  return (may_move ? kMovedOutlineMargin : kOutlineMargin) + kOutlineMarginPerCoordinate * largest;
}

double SegmentDistance(const BoundaryEdge& edge, Point2 p) {
  const double dx = edge.b.x - edge.a.x;
  const double dy = edge.b.y - edge.a.y;
  const double along = ((p.x - edge.a.x) * dx + (p.y - edge.a.y) * dy) / (dx * dx + dy * dy);
  const double part = along > 0 ? std::min(along, 1.0) : 0.0;
  const double distance = std::hypot(p.x - edge.a.x - part * dx, p.y - edge.a.y - part * dy);
  return std::isnan(distance) ? 0 : distance;  // overflow: near, and so not judged
}

}  // namespace

Outline::Outline(const Case& c, bool may_move)
    : boundary_(BoundaryOf(c)), margin_(MarginOf(c.scene, may_move)) {}

bool Outline::IsNear(Point2 p) const {
  return std::ranges::any_of(
      boundary_, [&](const BoundaryEdge& edge) { return SegmentDistance(edge, p) <= margin_; });
}

}  // namespace rasterproof::props
