// A rasterizer with a bug, and its fuzz target: samples on a shared edge are covered twice.
#include "core/scene.h"
#include "kit/fuzz.h"

struct Mine {
  void Draw(const rasterproof::Scene& scene, rasterproof::CoverageCounts& counts) {
    for (const rasterproof::Triangle& t : scene.triangles) {
      const auto v = rasterproof::Corners(scene, t);
      const auto e = [&](std::size_t i, std::size_t j, double x, double y) {
        return (x - v[i].x) * (v[j].y - v[i].y) - (y - v[i].y) * (v[j].x - v[i].x);
      };
      for (int k = 0; k < scene.width * scene.height; ++k) {
        const double x = k % scene.width + 0.5, y = k / scene.width + 0.5;
        const double e0 = e(1, 2, x, y), e1 = e(2, 0, x, y), e2 = e(0, 1, x, y);
        const auto sample = static_cast<std::size_t>(k);
        if (e0 >= 0 && e1 >= 0 && e2 >= 0) ++counts.front[sample];
        if (e0 <= 0 && e1 <= 0 && e2 <= 0) ++counts.back[sample];
      }
    }
  }
};

RASTERPROOF_FUZZ_TARGET(Mine, "SharedEdgeSamplesAreCoveredOnce")
