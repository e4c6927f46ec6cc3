// Which scenes a mode that flushes subnormal numbers could change.
#include "props/compare/can_touch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

#include "core/float_mode.h"
#include "core/scene.h"

namespace rasterproof::props {
namespace {

Scene Containing(double x) {
  Scene scene;
  scene.width = scene.height = 16;
  scene.vertices = {{.x = 1, .y = 2}, {.x = 9, .y = 2}, {.x = x, .y = 9}};
  scene.triangles = {{0, 1, 2}};
  return scene;
}

bool Flushes(const Scene& scene, Precision input) {
  return CanTouch(FloatMode::kFlushToZero, scene, input);
}

TEST(CanTouch, FlushingTouchesOnlyFarFromOneAndClipSpace) {
  for (const double x : {0.0, 0.5, 3.0, 4096.0, -7.25}) {
    EXPECT_FALSE(Flushes(Containing(x), Precision::kFloat32)) << x;
    EXPECT_FALSE(Flushes(Containing(x), Precision::kFloat64)) << x;
  }
  for (const double x : {0x1p-60, 0x1p-149, -0x1p62, 0x1p100}) {
    EXPECT_TRUE(Flushes(Containing(x), Precision::kFloat32)) << x;
    EXPECT_FALSE(Flushes(Containing(x), Precision::kFloat64)) << x;
  }
  for (const double x : {0x1p-500, 0x1p600}) {
    EXPECT_TRUE(Flushes(Containing(x), Precision::kFloat64)) << x;
  }
  for (const double x : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_TRUE(Flushes(Containing(x), Precision::kFloat32)) << x;
  }
  Scene clip = Containing(3);
  clip.clip_space = true;
  EXPECT_TRUE(Flushes(clip, Precision::kFloat64));
}

TEST(CanTouch, OtherModesAlwaysCould) {
  EXPECT_TRUE(CanTouch(FloatMode::kUpward, Containing(3), Precision::kFloat32));
  EXPECT_TRUE(CanTouch(FloatMode::kTrapping, Containing(3), Precision::kFloat64));
}

// An edge value over an area, as a weight of a sample, and the sign of either.
std::array<float, 2> Weight(const std::array<float, 8>& p, FloatMode mode) {
  const WithinFloatMode within(mode);
  const auto edge = [&p](std::size_t a, std::size_t b, std::size_t c) {
    const volatile float left = (p[2 * c] - p[2 * a]) * (p[2 * b + 1] - p[2 * a + 1]);
    const volatile float right = (p[2 * c + 1] - p[2 * a + 1]) * (p[2 * b] - p[2 * a]);
    const volatile float difference = left - right;
    return difference;
  };
  const float value = edge(0, 1, 3);
  const volatile float weight = value / edge(0, 1, 2);
  return {value, weight};
}

TEST(CanTouch, WhereFlushingCouldNotTouchItChangesNoEdgeValueAndNoWeight) {
  std::mt19937 bits(1);  // NOLINT: the same numbers in every run
  int untouched = 0;
  int changed_elsewhere = 0;
  for (int k = 0; k < 200000; ++k) {
    const int low = -static_cast<int>(bits() % 60);
    Scene scene = Containing(3);
    std::array<float, 8> p{};
    for (float& x : p) {
      const auto significand = static_cast<float>(1 + (bits() % 4 == 0 ? bits() % 4 : 0));
      const auto tail = static_cast<float>(bits() % 8) * 0x1p-23F;
      x = std::ldexp(significand + tail, low + static_cast<int>(bits() % 4));
    }
    for (std::size_t v = 0; v < 3; ++v) {
      scene.vertices[v].x = p[2 * v];
      scene.vertices[v].y = p[2 * v + 1];
    }
    p[6] = p[7] = 0x1p-8F;
    const bool could = Flushes(scene, Precision::kFloat32);
    const auto usual = Weight(p, FloatMode::kUsual);
    const auto flushed = Weight(p, FloatMode::kFlushToZero);
    const bool same = usual == flushed || std::isnan(usual[1]);
    if (!could) {
      ++untouched;
      EXPECT_TRUE(same) << low;
    } else if (!same) {
      ++changed_elsewhere;
    }
  }
  EXPECT_GT(untouched, 10000);
  EXPECT_GT(changed_elsewhere, 10);
}

}  // namespace
}  // namespace rasterproof::props
