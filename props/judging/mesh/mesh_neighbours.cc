#include "props/judging/mesh/mesh_neighbours.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "props/judging/places.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// x, y, w of both ends. -0 and +0 compare equal, as they must.
using DirectedEdge = std::array<double, 6>;

DirectedEdge Key(const Vertex& a, const Vertex& b) { return {a.x, a.y, a.w, b.x, b.y, b.w}; }

// The scene by whose positions an edge is shared. Different clip-space vertices can have one place
// on the grid of the profile; a subject need not know that.
const Scene& Keyed(const PlacedCase& c) { return c.scene.clip_space ? c.scene : c.placed; }

struct SideOfTriangle {
  std::size_t triangle = 0;
  int edge = 0;
};

}  // namespace

std::vector<Neighbours> SharedEdges(const PlacedCase& c, std::size_t limit) {
  const Scene& keyed = Keyed(c);
  std::map<DirectedEdge, SideOfTriangle> owner;
  std::vector<Neighbours> pairs;
  for (std::size_t t = 0; t < keyed.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(keyed, keyed.triangles[t]);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    const std::int8_t facing = c.facings[t];
    if (facing == 0) continue;
    for (int i = 0; i < 3; ++i) {
      const Vertex& a = EdgeStart(v, i);
      const Vertex& b = EdgeEnd(v, i);
      owner.emplace(Key(a, b), SideOfTriangle{t, i});
      const auto other = owner.find(Key(b, a));
      if (other == owner.end() || other->second.triangle == t) continue;
      if (c.facings[other->second.triangle] != facing) continue;
      pairs.push_back({t, other->second.triangle, i, other->second.edge});
    }
  }
  if (pairs.size() <= limit) return pairs;
  std::vector<Neighbours> spread;
  for (std::size_t k = 0; k < limit; ++k) spread.push_back(pairs[k * pairs.size() / limit]);
  return spread;
}

std::vector<BoundaryEdge> BoundaryOf(const Scene& scene) {
  std::map<DirectedEdge, int> left;  // occurrences not yet cancelled
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    for (int i = 0; i < 3; ++i) {
      const auto opposite = left.find(Key(EdgeEnd(v, i), EdgeStart(v, i)));
      if (opposite != left.end() && opposite->second > 0) {
        --opposite->second;
      } else {
        ++left[Key(EdgeStart(v, i), EdgeEnd(v, i))];
      }
    }
  }
  std::vector<BoundaryEdge> boundary;
  for (const auto& [key, times] : left) {
    if (times > 0) {
      boundary.push_back({{key[0], key[1], 0, key[2]}, {key[3], key[4], 0, key[5]}});
    }
  }
  return boundary;
}

bool IsClosed(const Scene& scene) {
  std::map<DirectedEdge, std::int64_t> balance;
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    for (int i = 0; i < 3; ++i) {
      ++balance[Key(EdgeStart(v, i), EdgeEnd(v, i))];
      --balance[Key(EdgeEnd(v, i), EdgeStart(v, i))];
    }
  }
  return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
}

}  // namespace rasterproof::props
