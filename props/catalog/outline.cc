#include "props/catalog/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::props {
namespace {

// How far from the outline a sample must be where the outline is not judged. Edge values of float32
// displace an edge by at most a few 2^-24 of the largest coordinate (docs/mathematics.md, forward
// bounds): 2^-18 of it is generous. A watertight subject may also have moved its vertices by
// snapping them to a grid of its own: kMovedOutlineMargin.
constexpr double kOutlineMarginPerCoordinate = 0x1p-18;
constexpr double kOutlineMargin = 0x1p-10;

double LargestCoordinate(const Scene& scene) {
  double largest = 0;
  for (const Vertex& v : scene.vertices) {
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  return largest;
}

// How far the line N . (p, 1) = 0, N = V_b x V_a, moves on the target if each product in N and each
// of the sum's terms is off by a 2^-18 of itself: the sum of their sizes over the length of
// (N_x, N_y).
double HomogeneousMargin(const Scene& scene, const Vertex& a, const Vertex& b) {
  const auto sizes = [](double p, double q, double r, double s) {
    return std::fabs(p * q) + std::fabs(r * s);
  };
  const double terms = sizes(b.y, a.w, b.w, a.y) * scene.width +
                       sizes(b.w, a.x, b.x, a.w) * scene.height + sizes(b.x, a.y, a.x, b.y);
  const double length = std::hypot(b.y * a.w - b.w * a.y, b.w * a.x - b.x * a.w);
  const double margin = kOutlineMarginPerCoordinate * terms / length;
  return std::isnan(margin) ? std::numeric_limits<double>::infinity() : margin;
}

double MovedBy(bool may_move) { return may_move ? kMovedOutlineMargin : kOutlineMargin; }

}  // namespace

Outline::Outline(const Case& c, bool may_move) : largest_(LargestCoordinate(c.scene)) {
  for (const BoundaryEdge& edge : BoundaryOf(c)) Add(c, edge, MovedBy(may_move));
}

Outline Outline::OfAllEdges(const Case& c, bool may_move) {
  Outline all;
  all.largest_ = LargestCoordinate(c.scene);
  const Scene scene = c.scene.clip_space ? c.scene : SnapScene(c.scene, c.profile);
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    for (int i = 0; i < 3; ++i) all.Add(c, {EdgeStart(v, i), EdgeEnd(v, i)}, MovedBy(may_move));
  }
  return all;
}

void Outline::Add(const Case& c, const BoundaryEdge& edge, double moved) {
  const double rounded = c.scene.clip_space ? HomogeneousMargin(c.scene, edge.a, edge.b)
                                            : kOutlineMarginPerCoordinate * largest_;
  const VisibleEdge seen(edge.a, edge.b);
  if (!seen.IsEmpty()) edges_.push_back({seen, moved + rounded});
}

bool Outline::IsNear(Point2 p) const {
  return std::ranges::any_of(
      edges_, [&](const Edge& edge) { return edge.seen.Distance(p) <= edge.margin; });
}

}  // namespace rasterproof::props
