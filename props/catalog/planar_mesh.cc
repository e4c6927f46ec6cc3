#include "props/catalog/planar_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/scene.h"
#include "exact/winding.h"
#include "props/catalog/mesh_neighbours.h"
#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

// How far from the outline a sample must be where the outline is not judged. Edge values of float32
// displace an edge by at most a few 2^-24 of the largest coordinate (docs/mathematics.md, forward
// bounds): 2^-18 of it is generous. A watertight subject may also have moved its vertices by
// snapping them to a grid of its own: a pixel is generous for that.
constexpr double kOutlineMarginPerCoordinate = 0x1p-18;
constexpr double kOutlineMargin = 0x1p-10;
constexpr double kWatertightOutlineMargin = 1;

double MarginOf(const Scene& scene, bool watertight_only) {
  double largest = 0;
  for (const Vertex& v : scene.vertices) {
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  return (watertight_only ? kWatertightOutlineMargin : kOutlineMargin) +
         kOutlineMarginPerCoordinate * largest;
}

double SegmentDistance(const BoundaryEdge& edge, Point2 p) {
  const double dx = edge.b.x - edge.a.x;
  const double dy = edge.b.y - edge.a.y;
  const double along = ((p.x - edge.a.x) * dx + (p.y - edge.a.y) * dy) / (dx * dx + dy * dy);
  const double part = along > 0 ? std::min(along, 1.0) : 0.0;
  const double distance = std::hypot(p.x - edge.a.x - part * dx, p.y - edge.a.y - part * dy);
  return std::isnan(distance) ? 0 : distance;  // overflow: near, and so not judged
}

Verdict NotExercised(const char* why) { return {Outcome::kNotExercised, 0, 0, why, std::nullopt}; }

}  // namespace

bool OwnsEdgesConsistently(const Profile& profile) { return !profile.fill_rule.inclusive; }

Verdict JudgePlanarMesh(Subject& subject, const Case& c, const MeshView& view) {
  const exact::MeshShape shape = exact::ShapeOf(c.scene, c.profile);
  if (shape.folded) return NotExercised("the snapped mesh is folded");
  const bool watertight_only = !HasOneModel(c.profile);
  if (watertight_only && shape.degenerate != 0) {
    return NotExercised("the snapped mesh has triangles of zero area");
  }
  const std::vector<std::int64_t> winding = exact::BoundaryWinding(c.scene, c.profile);
  if (std::ranges::any_of(winding, [](std::int64_t w) { return std::abs(w) > 1; })) {
    return NotExercised("the mesh overlaps itself");
  }
  const std::vector<BoundaryEdge> boundary =
      watertight_only || view.spares_outline ? BoundaryOf(c) : std::vector<BoundaryEdge>();
  const double margin = MarginOf(c.scene, watertight_only);
  const auto is_judged = [&](const SamplePlace& place) {
    return (!view.looks_at || view.looks_at(place)) &&
           std::ranges::none_of(boundary, [&](const BoundaryEdge& edge) {
             return SegmentDistance(edge, place.at) <= margin;
           });
  };
  const CoverageCounts counts = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (int row = 0; row < counts.height; ++row) {
    for (int x = 0; x < counts.width; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const std::size_t k = counts.Index(x, row, s);
        const auto expected = static_cast<std::uint32_t>(std::abs(winding[k]));
        const bool is_right = counts.Count(k) == expected;
        if (is_right && expected == 0) continue;  // outside and left alone: not worth counting
        const SamplePlace place = PlaceOf(c, x, row, s);
        if (!is_judged(place)) continue;
        ++exercised;
        if (is_right) continue;
        Witness witness =
            WitnessAt(-1, -1, place, "covered " + std::to_string(counts.Count(k)) + " times",
                      expected == 1 ? "exactly once" : "outside: never");
        return Verdict::Violated(
            exercised,
            counts.Count(k) < expected ? "a gap in the mesh" : "a sample covered too often",
            witness);
      }
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
