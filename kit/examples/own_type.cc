// A rasterizer in C++ and the whole command for it:  ./own_type check
#include <cstddef>

#include "core/scene.h"
#include "kit/main.h"

using rasterproof::CoverageCounts;
using rasterproof::Scene;

struct Naive {
  void Draw(const Scene& scene, CoverageCounts& counts) {
    for (const rasterproof::Triangle& t : scene.triangles) {
      const auto v = rasterproof::Corners(scene, t);
      const auto edge = [&](std::size_t i, std::size_t j, float x, float y) {
        const auto ax = static_cast<float>(v[i].x), ay = static_cast<float>(v[i].y);
        const auto bx = static_cast<float>(v[j].x), by = static_cast<float>(v[j].y);
        return (x - ax) * (by - ay) - (y - ay) * (bx - ax);
      };
      for (int row = 0; row < scene.height; ++row) {
        for (int i = 0; i < scene.width; ++i) {
          const float x = static_cast<float>(i) + 0.5F, y = static_cast<float>(row) + 0.5F;
          const float e0 = edge(1, 2, x, y), e1 = edge(2, 0, x, y), e2 = edge(0, 1, x, y);
          if (e0 >= 0 && e1 >= 0 && e2 >= 0) ++counts.front[counts.Index(i, row)];
          if (e0 <= 0 && e1 <= 0 && e2 <= 0) ++counts.back[counts.Index(i, row)];
        }
      }
    }
  }
};

RASTERPROOF_MAIN(Naive)
