#include "props/catalog/mesh_neighbours.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"

namespace rasterproof::props {
namespace {

// x, y, w of both ends. -0 and +0 compare equal, as they must.
using DirectedEdge = std::array<double, 6>;

DirectedEdge Key(const Vertex& a, const Vertex& b) { return {a.x, a.y, a.w, b.x, b.y, b.w}; }

Scene InPlace(const Case& c) {
  return c.scene.clip_space ? c.scene : SnapScene(c.scene, c.profile);
}

int FacingOf(const std::array<Vertex, 3>& v) {
  return exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
}

const Vertex& Start(const std::array<Vertex, 3>& v, int edge) {
  return v[static_cast<std::size_t>((edge + 1) % 3)];
}
const Vertex& End(const std::array<Vertex, 3>& v, int edge) {
  return v[static_cast<std::size_t>((edge + 2) % 3)];
}

}  // namespace

std::vector<Neighbours> SharedEdges(const Case& c, std::size_t limit) {
  const Scene scene = InPlace(c);
  std::map<DirectedEdge, std::size_t> owner;
  std::vector<Neighbours> pairs;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    const int facing = scene.clip_space ? 0 : FacingOf(v);
    if (!scene.clip_space && facing == 0) continue;
    for (int i = 0; i < 3; ++i) {
      const Vertex& a = Start(v, i);
      const Vertex& b = End(v, i);
      owner.emplace(Key(a, b), t);
      const auto other = owner.find(Key(b, a));
      if (other == owner.end() || other->second == t) continue;
      const auto theirs = Corners(scene, scene.triangles[other->second]);
      if (!scene.clip_space && FacingOf(theirs) != facing) continue;
      pairs.push_back({t, other->second, i, WindowPoint(a), WindowPoint(b)});
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
      const auto opposite = left.find(Key(End(v, i), Start(v, i)));
      if (opposite != left.end() && opposite->second > 0) {
        --opposite->second;
      } else {
        ++left[Key(Start(v, i), End(v, i))];
      }
    }
  }
  std::vector<BoundaryEdge> boundary;
  for (const auto& [key, times] : left) {
    if (times > 0) boundary.push_back({{key[0], key[1]}, {key[3], key[4]}});
  }
  return boundary;
}

}  // namespace rasterproof::props
