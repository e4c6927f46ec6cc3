// Properties of your own on hard scenes, by RapidCheck. The rasterizer covers every sample on an
// edge: where two triangles share one, twice. RapidCheck finds such a pair, and shrinks it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "kit/rapidcheck.h"

namespace {

using rasterproof::Scene;

double Edge(const rasterproof::Vertex& a, const rasterproof::Vertex& b, double x, double y) {
  return (x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x);
}

// How many triangles cover each pixel's centre. The bug: `>=` on all edges, where one of two
// neighbours owns what lies on their edge.
std::vector<int> Draw(const Scene& scene) {
  std::vector<int> counts(static_cast<std::size_t>(scene.width) *
                          static_cast<std::size_t>(scene.height));
  for (const rasterproof::Triangle& t : scene.triangles) {
    const auto v = rasterproof::Corners(scene, t);
    const double area = Edge(v[0], v[1], v[2].x, v[2].y);
    if (area == 0) continue;
    const double side = area > 0 ? 1 : -1;
    for (int row = 0; row < scene.height; ++row) {
      for (int i = 0; i < scene.width; ++i) {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k)
          inside = inside && side * Edge(v[k], v[(k + 1) % 3], i + 0.5, row + 0.5) >= 0;
        const std::size_t at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(scene.width);
        if (inside) ++counts[at + static_cast<std::size_t>(i)];
      }
    }
  }
  return counts;
}

}  // namespace

int main() {
  const bool holds = rc::check("no sample of two neighbours is covered twice", [] {
    const Scene pair = *rasterproof::kit::PairsThatShareAnEdge();
    for (const int count : Draw(pair)) RC_ASSERT(count <= 1);
  });
  std::puts(holds ? "nothing was found" : "the bug was found");
  return holds ? 0 : 1;
}
