#include "props/catalog/outline.h"

#include <algorithm>
#include <cmath>

#include "core/profile.h"
#include "core/scene.h"
#include "props/catalog/free_choices.h"

namespace rasterproof::props {
namespace {

double MarginOf(const Scene& scene, double moved) {
  double largest = 0;
  for (const Vertex& v : scene.vertices) {
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  return moved + kOutlineMarginPerCoordinate * largest;
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

Outline::Outline(const Case& c)
    : boundary_(BoundaryOf(SnapScene(c.scene, c.profile))),
      margin_(MarginOf(c.scene, kOutlineMargin)) {}

Outline Outline::OfMoved(const Case& c, double most_moved) {
  Outline outline;
  outline.boundary_ = BoundaryOf(UnsnappedScene(c));
  outline.margin_ = MarginOf(c.scene, std::max(kMovedOutlineMargin, most_moved));
  return outline;
}

bool Outline::IsNear(Point2 p) const {
  return std::ranges::any_of(
      boundary_, [&](const BoundaryEdge& edge) { return SegmentDistance(edge, p) <= margin_; });
}

}  // namespace rasterproof::props
