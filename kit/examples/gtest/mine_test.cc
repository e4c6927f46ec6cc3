// A rasterizer's properties as GoogleTest cases:  ./mine_test --gtest_filter='*SharedEdge*'
#include "rasterproof/kit/gtest.h"

struct Inclusive {
  static bool Draw(const rasterproof_scene& scene, const rasterproof_target& target) {
    for (std::size_t t = 0; t < 3 * scene.triangle_count; t += 3) {
      const auto at = [&](std::size_t k, int axis) {
        return static_cast<float>(scene.vertices[4 * scene.triangles[t + k % 3] + axis]);
      };
      for (int row = 0; row < scene.height; ++row) {
        for (int column = 0; column < scene.width; ++column) {
          const float x = static_cast<float>(column) + 0.5F, y = static_cast<float>(row) + 0.5F;
          int inside = 0, outside = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const float e = (x - at(k, 0)) * (at(k + 1, 1) - at(k, 1)) -
                            (y - at(k, 1)) * (at(k + 1, 0) - at(k, 0));
            inside += e >= 0, outside += e <= 0;
          }
          target.front[row * target.stride + column] += inside == 3 || outside == 3;
        }
      }
    }
    return true;
  }
};

RASTERPROOF_TEST(Textbook, Inclusive, "real", 50)
