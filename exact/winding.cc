#include "exact/winding.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/row_edge.h"
#include "exact/sample_frame.h"
#include "exact/signs.h"

namespace rasterproof::exact {
namespace {

// A position as a key. Comparing doubles makes -0 and +0 one place.
struct Position {
  double x;
  double y;

  explicit Position(const Vertex& v) : x(v.x), y(v.y) {}
  friend auto operator<=>(const Position&, const Position&) = default;
};

struct DirectedEdge {
  Position from;
  Position to;

  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

// The directed edges of the snapped scene's finite triangles in screen axes, none of length zero.
std::vector<DirectedEdge> EdgesOf(const PlacedScene& scene, const SampleFrame& frame) {
  if (scene.placed.clip_space) {
    throw InputError("scene \"" + scene.scene.name + "\"",
                     "boundary winding needs window space, and its vertices have w",
                     "project the scene, or use homogeneous coverage");
  }
  std::vector<DirectedEdge> edges;
  for (const Triangle& t : scene.placed.triangles) {
    const std::optional<std::array<Vertex, 3>> v = ScreenTriangle(scene.placed, t, frame);
    if (!v) continue;
    for (unsigned k = 0; k < 3; ++k) {
      const DirectedEdge edge{Position((*v)[k]), Position((*v)[(k + 1) % 3])};
      if (edge.from != edge.to) edges.push_back(edge);
    }
  }
  return edges;
}

// An edge of the boundary, from its lesser to its greater end, and how often it remains in that
// direction (negative: in the other).
struct BoundaryEdge {
  DirectedEdge edge;
  std::int64_t multiplicity = 0;
};

std::vector<BoundaryEdge> BoundaryOf(const std::vector<DirectedEdge>& edges) {
  std::vector<BoundaryEdge> all;
  all.reserve(edges.size());
  for (const DirectedEdge& e : edges) {
    const bool forward = e.from < e.to;
    all.push_back({forward ? e : DirectedEdge{e.to, e.from}, forward ? 1 : -1});
  }
  std::ranges::sort(all, {}, &BoundaryEdge::edge);
  std::vector<BoundaryEdge> boundary;
  for (std::size_t k = 0; k < all.size();) {
    BoundaryEdge sum{all[k].edge, 0};
    for (; k < all.size() && all[k].edge == sum.edge; ++k) sum.multiplicity += all[k].multiplicity;
    if (sum.multiplicity != 0) boundary.push_back(sum);
  }
  return boundary;
}

// Adds the edge's part in the winding number, as differences along the rows it crosses: the ray
// from a sample to the right meets the edge iff the sample lies left of it. A counter-clockwise
// curve goes up on screen on its right side: a crossing counts +1 upwards, -1 downwards.
void AddCrossings(const BoundaryEdge& b, const SampleFrame& frame, const CoverageCounts& shape,
                  std::vector<std::int64_t>& winding) {
  const Point2 from{b.edge.from.x, b.edge.from.y};
  const Point2 to{b.edge.to.x, b.edge.to.y};
  if (from.y == to.y) return;
  const bool down = from.y < to.y;
  const Point2 upper = down ? from : to;
  const Point2 lower = down ? to : from;
  const std::int64_t crossing = down ? -b.multiplicity : b.multiplicity;
  const RowEdge edge(upper, lower);
  const bool strict = frame.rule.sign_y < 0;
  std::uint64_t certain = 0;
  for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
    const auto row_of = [&](double y) {
      return FirstRowAtOrBelow(y, strict, frame.offsets[s].y, frame.clip.y0, frame.clip.y1);
    };
    const int end = row_of(lower.y);
    for (int row = row_of(upper.y); row < end; ++row) {
      const int first_right = edge.FirstColumnAtSide(frame, row, s, +1, certain);
      if (first_right == 0) continue;
      const int sample = static_cast<int>(s);
      winding[shape.Index(0, row, sample)] += crossing;
      if (first_right < shape.width) winding[shape.Index(first_right, row, sample)] -= crossing;
    }
  }
  ThreadTiers().filter += certain;
}

}  // namespace

std::vector<std::int64_t> BoundaryWinding(const PlacedScene& scene) {
  SampleFrame frame(scene.scene, scene.profile, {});
  if (!frame.rule.IsConsistent()) frame.rule = kTopLeft;
  CoverageCounts shape;
  shape.width = scene.scene.width;
  shape.height = scene.scene.height;
  shape.samples = scene.profile.pattern.samples();
  std::vector<std::int64_t> winding(CoverageCounts::Size(shape.width, shape.height, shape.samples));
  for (const BoundaryEdge& b : BoundaryOf(EdgesOf(scene, frame))) {
    AddCrossings(b, frame, shape, winding);
  }
  const auto stride = static_cast<std::size_t>(shape.samples);
  for (int row = 0; row < shape.height; ++row) {
    for (std::size_t k = shape.Index(1, row); k < shape.Index(0, row + 1); ++k) {
      winding[k] += winding[k - stride];
    }
  }
  return winding;
}

}  // namespace rasterproof::exact
