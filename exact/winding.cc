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

// The finite triangles of the snapped scene in screen axes, and their directed edges.
struct Mesh {
  std::vector<std::array<Point2, 3>> triangles;
  std::vector<DirectedEdge> edges;  // sorted; none of length zero
};

Mesh MeshOf(const PlacedScene& scene, const SampleFrame& frame) {
  if (scene.placed.clip_space) {
    throw InputError("scene \"" + scene.scene.name + "\"",
                     "boundary winding needs window space, and its vertices have w",
                     "project the scene, or use homogeneous coverage");
  }
  Mesh mesh;
  for (const Triangle& t : scene.placed.triangles) {
    const std::optional<std::array<Vertex, 3>> v = ScreenTriangle(scene.placed, t, frame);
    if (!v) continue;
    mesh.triangles.push_back({WindowPoint((*v)[0]), WindowPoint((*v)[1]), WindowPoint((*v)[2])});
    for (unsigned k = 0; k < 3; ++k) {
      const DirectedEdge edge{Position((*v)[k]), Position((*v)[(k + 1) % 3])};
      if (edge.from != edge.to) mesh.edges.push_back(edge);
    }
  }
  std::ranges::sort(mesh.edges);
  return mesh;
}

// An edge of the boundary, from its lesser to its greater end, and how often it remains in that
// direction (negative: in the other).
struct BoundaryEdge {
  DirectedEdge edge;
  std::int64_t multiplicity = 0;
};

std::vector<BoundaryEdge> BoundaryOf(const Mesh& mesh) {
  std::vector<BoundaryEdge> all;
  all.reserve(mesh.edges.size());
  for (const DirectedEdge& e : mesh.edges) {
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
  for (const BoundaryEdge& b : BoundaryOf(MeshOf(scene, frame))) {
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

MeshShape ShapeOf(const PlacedScene& scene) {
  const SampleFrame frame(scene.scene, scene.profile, {});
  const Mesh mesh = MeshOf(scene, frame);
  MeshShape shape;
  const auto fronts = std::ranges::count(scene.facings, 1);
  const auto backs = std::ranges::count(scene.facings, -1);
  shape.folded = fronts != 0 && backs != 0;
  shape.degenerate = mesh.triangles.size() - static_cast<std::size_t>(fronts + backs);
  shape.balanced = std::ranges::adjacent_find(mesh.edges) == mesh.edges.end();
  shape.boundary_edges = BoundaryOf(mesh).size();
  shape.closed = shape.boundary_edges == 0;
  return shape;
}

}  // namespace rasterproof::exact
