#include "props/judging/freedom/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/profile.h"
#include "core/scene.h"
#include "props/judging/freedom/free_choices.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

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
  const double length = Hypot(b.y * a.w - b.w * a.y, b.w * a.x - b.x * a.w);
  const double margin = kOutlineMarginPerCoordinate * terms / length;
  return std::isnan(margin) ? std::numeric_limits<double>::infinity() : margin;
}

// How far a subject may have displaced edges beyond `most_moved`, the legal models' reach.
double Displaced(const PlacedCase& c, double most_moved) {
  const bool states_samples = c.profile.contract == Contract::kSampleExact;
  const double walked =
      states_samples ? 0 : WalkMargin(static_cast<double>(c.scene.width) + c.scene.height);
  return std::max(kMovedOutlineMargin, most_moved) + SampleReach(c.profile) + walked;
}

// Positions by which edges are one in every legal model.
Scene AsGiven(const PlacedCase& c) { return c.scene.clip_space ? c.scene : UnsnappedScene(c); }

// The clip-space triangles that the canonical model does not cull: their boundary is seen too.
Scene WithoutCulled(const PlacedCase& c) {
  Scene scene = c.scene;
  scene.triangles.clear();
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!std::ranges::binary_search(c.culled, t)) scene.triangles.push_back(c.scene.triangles[t]);
  }
  return scene;
}

}  // namespace

Outline::Outline(const PlacedCase& c) : largest_(LargestCoordinate(c.scene)) {
  const Scene& scene = c.scene.clip_space ? c.scene : c.placed;
  AddBoundary(scene, kOutlineMargin);
  if (c.scene.clip_space && !c.culled.empty()) AddBoundary(WithoutCulled(c), kOutlineMargin);
}

Outline Outline::OfMoved(const PlacedCase& c, double most_moved) {
  const TieOwnership ties = c.profile.freedom.ties;
  if (ties == TieOwnership::kOpen) return OfAllEdges(c, most_moved);
  Outline outline;
  outline.largest_ = LargestCoordinate(c.scene);
  const Scene scene = AsGiven(c);
  const double moved = Displaced(c, most_moved);
  if (ties == TieOwnership::kPerEdge) outline.AddVertices(scene, moved);
  outline.AddBoundary(scene, moved);
  if (scene.clip_space && !c.culled.empty()) outline.AddBoundary(WithoutCulled(c), moved);
  return outline;
}

Outline Outline::OfAllEdges(const PlacedCase& c, double most_moved) {
  Outline all;
  all.largest_ = LargestCoordinate(c.scene);
  const Scene scene = AsGiven(c);
  const double moved = Displaced(c, most_moved);
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    for (int i = 0; i < 3; ++i) all.Add(scene, {EdgeStart(v, i), EdgeEnd(v, i)}, moved);
  }
  return all;
}

void Outline::AddBoundary(const Scene& scene, double moved) {
  for (const BoundaryEdge& edge : BoundaryOf(scene)) Add(scene, edge, moved);
}

void Outline::Add(const Scene& scene, const BoundaryEdge& edge, double moved) {
  const double rounded = scene.clip_space ? HomogeneousMargin(scene, edge.a, edge.b)
                                          : kOutlineMarginPerCoordinate * largest_;
  const VisibleEdge seen(edge.a, edge.b);
  if (!seen.IsEmpty()) edges_.push_back({seen, moved + rounded});
}

void Outline::AddVertices(const Scene& scene, double moved) {
  const double margin = moved + kOutlineMarginPerCoordinate * largest_;
  for (const Vertex& v : scene.vertices) {
    if (!IsFinite(v) || !(v.w > 0)) continue;  // behind the eye it is seen nowhere
    vertices_.push_back({{v.x / v.w, v.y / v.w}, margin});
  }
}

bool Outline::IsNear(Point2 p) const {
  return std::ranges::any_of(edges_,
                             [&](const SeenEdge& e) { return e.seen.Distance(p) <= e.margin; }) ||
         std::ranges::any_of(vertices_, [&](const SeenVertex& v) {
           return Hypot(p.x - v.at.x, p.y - v.at.y) <= v.margin;
         });
}

}  // namespace rasterproof::props
