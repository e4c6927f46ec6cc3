// Suites of kit/gtest.h whose tests must pass, fail and crash.
#include <cstdio>
#include <cstdlib>

#include "rasterproof/kit/gtest.h"

// The example of a plugin, which is right.
struct Right {
  static void Describe(rasterproof_plugin& plugin) { plugin.coverage = RASTERPROOF_FACING_COUNTS; }
  static bool Draw(const rasterproof_scene& scene, const rasterproof_target& target) {
    std::puts("what a rasterizer prints is no answer");
    return rasterproof_plugin_describe()->draw(nullptr, &scene, &target) == 0;
  }
};
RASTERPROOF_TEST(Right, Right, "gl-canonical", 60)

// Right, and dies over scenes of many triangles.
struct Crashing {
  static bool Draw(const rasterproof_scene& scene, const rasterproof_target& target) {
    if (scene.triangle_count > 40) std::abort();
    rasterproof_target all = target;
    static uint32_t back[1 << 20];
    all.back = back;
    const bool drawn = rasterproof_plugin_describe()->draw(nullptr, &scene, &all) == 0;
    for (int row = 0; row < scene.height; ++row) {
      for (std::size_t k = 0; k < target.stride; ++k) {
        const std::size_t at = static_cast<std::size_t>(row) * target.stride + k;
        target.front[at] += back[at];
        back[at] = 0;
      }
    }
    return drawn;
  }
};
RASTERPROOF_TEST(Crashing, Crashing, "gl-canonical", 60)

// Refuses all, and says what the command says of properties that do not apply.
struct Refusing {
  static bool Draw(const rasterproof_scene&, const rasterproof_target&) {
    std::fputs("not applicable   Refusing it takes no scene: all properties\n", stderr);
    return false;
  }
};
RASTERPROOF_TEST(Refusing, Refusing, "real", 60)

struct Hanging {
  static bool Draw(const rasterproof_scene&, const rasterproof_target&) {
    for (volatile int k = 0;; k = 1 - k) {
    }
  }
};
RASTERPROOF_TEST(Hanging, Hanging, "real", 60)
