// The kernels against plain definitions of them, by every method, sink and target.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "reference/kernels/kernel.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "tests/reference/kernel_definitions.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference::kernels {
namespace {

struct OwnedScene {
  std::string name;
  std::vector<KernelVertex> vertices;
  std::vector<std::uint32_t> indices;
  int width = 1;
  int height = 1;

  KernelScene View() const { return {vertices, indices, width, height}; }
  void Add(const KernelTriangle& t) {
    for (const KernelVertex& v : t) {
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(v);
    }
  }
};

float Half(RandomValues& random, int low, int high) {
  return static_cast<float>(random.Integer(2 * low, 2 * high)) * 0.5F;
}

// One coordinate of a target of this size: on centres, on borders, anywhere, beside it, far off.
float Coordinate(RandomValues& random, int size, int kind) {
  switch (kind) {
    case 0:
      return Half(random, 0, size);
    case 1:
      return static_cast<float>(random.Uniform(-0.2 * size, 1.2 * size));
    case 2:
      return static_cast<float>(random.Uniform(0, size));
    case 3:
      return static_cast<float>(random.Uniform(-40 * size, 40 * size));
    case 4:
      return static_cast<float>(random.Integer(-16 * 256, size * 256)) * 0x1p-8F;
    default:
      return random.LogUniform<float>(-140, 127);
  }
}

OwnedScene RandomScene(std::uint64_t seed, int width, int height, int triangles) {
  OwnedScene scene;
  scene.name =
      std::to_string(width) + "x" + std::to_string(height) + " seed " + std::to_string(seed);
  scene.width = width;
  scene.height = height;
  RandomValues random(seed);
  for (int i = 0; i < triangles; ++i) {
    KernelTriangle t;
    const int kind = random.Integer(0, 6);
    const float x = Coordinate(random, width, 2);
    const float y = Coordinate(random, height, 2);
    for (KernelVertex& v : t) {
      v.z = static_cast<float>(random.Uniform(-1, 1));
      if (kind == 6) {  // up to twelve pixels wide
        v.x = x + static_cast<float>(random.Uniform(-6, 6));
        v.y = y + static_cast<float>(random.Uniform(-6, 6));
      } else {
        v.x = Coordinate(random, width, kind);
        v.y = Coordinate(random, height, kind);
      }
    }
    if (random.Integer(0, 9) == 0) t[1].y = t[0].y;
    if (random.Integer(0, 9) == 0) t[2].x = t[1].x;
    if (random.Integer(0, 19) == 0) t[2] = t[0];
    scene.Add(t);
  }
  return scene;
}

OwnedScene ExtremeScene() {
  OwnedScene scene;
  scene.name = "extremes";
  scene.width = 75;
  scene.height = 13;
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kBig = std::numeric_limits<float>::max();
  constexpr std::array kValues{0.5F,     0.0F, -0.0F, 1e-45F, 12.5F, 16384.0F, -16384.0F,
                               16384.1F, 3e9F, kBig,  -kBig,  kInf,  -kInf,    NAN};
  RandomValues random(5);
  const auto value = [&] {
    return kValues[static_cast<std::size_t>(random.Integer(0, std::ssize(kValues) - 1))];
  };
  for (int i = 0; i < 500; ++i) {
    KernelTriangle t;
    for (KernelVertex& v : t) v = {value(), value(), value()};
    scene.Add(t);
  }
  return scene;
}

// More layers than a byte counts.
OwnedScene DeepScene() {
  OwnedScene scene;
  scene.name = "deep";
  scene.width = 70;
  scene.height = 20;
  for (int i = 0; i < 300; ++i) {
    scene.Add({{{1, 1, 0.5F}, {3, 6, 0.25F}, {6, 2, 0.75F}}});
    scene.Add({{{-9, -1, 0.5F}, {90, 10, 0.25F}, {-7, 19, 0.75F}}});
  }
  return scene;
}

std::vector<OwnedScene> Scenes() {
  std::vector<OwnedScene> scenes;
  scenes.push_back(RandomScene(1, 1, 1, Cases(200)));
  scenes.push_back(RandomScene(2, 67, 35, Cases(400)));
  scenes.push_back(RandomScene(3, 200, 9, Cases(300)));
  scenes.push_back(RandomScene(4, 131, 70, Cases(301)));
  scenes.push_back(RandomScene(5, 2100, 8, Cases(60)));
  scenes.push_back(ExtremeScene());
  scenes.push_back(DeepScene());
  OwnedScene empty;
  empty.name = "empty";
  empty.vertices.resize(1);
  scenes.push_back(empty);
  return scenes;
}

// The first pixel that differs, in words; empty if none does.
std::string FirstDifference(const Surface& surface, const std::vector<std::uint64_t>& expected) {
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::uint64_t wanted = expected[static_cast<std::size_t>(y * surface.width() + x)];
      if (surface.At(x, y) == wanted) continue;
      return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
             std::to_string(surface.At(x, y)) + ", not " + std::to_string(wanted);
    }
  }
  return "";
}

TEST(KernelsTest, EveryMethodSinkAndTargetDrawsItsDefinition) {
  for (const OwnedScene& scene : Scenes()) {
    for (const KernelMethod method : kKernelMethods) {
      for (const Sink sink : kSinks) {
        // What exactness is left out of states nothing.
        if (!Draws(method, sink) || method == KernelMethod::kExactUnsafe) continue;
        const auto expected = DefineSurface(method, sink, scene.View());
        for (const Target target : SupportedTargets()) {
          Surface surface(sink, scene.width, scene.height);
          Draw(method, target, scene.View(), surface);
          EXPECT_EQ(FirstDifference(surface, expected), "")
              << scene.name << ' ' << NameOf(method) << ' ' << NameOf(sink) << ' '
              << NameOf(target);
        }
      }
    }
  }
}

TEST(KernelsTest, ASurfaceKeepsWhatWasDrawnBefore) {
  const OwnedScene scene = RandomScene(6, 67, 35, 40);
  const KernelScene view = scene.View();
  for (const KernelMethod method : kKernelMethods) {
    for (const Sink sink : kSinks) {
      if (!Draws(method, sink) || sink == Sink::kId) continue;
      for (const Target target : SupportedTargets()) {
        Surface whole(sink, 67, 35);
        Draw(method, target, view, whole);
        Surface halves(sink, 67, 35);
        const std::size_t middle = 3 * 17;
        KernelScene part = view;
        part.indices = view.indices.first(middle);
        Draw(method, target, part, halves);
        part.indices = view.indices.subspan(middle);
        Draw(method, target, part, halves);
        for (int y = 0; y < 35; ++y) {
          for (int x = 0; x < 67; ++x) ASSERT_EQ(halves.At(x, y), whole.At(x, y));
        }
      }
    }
  }
}

// The tiles' snap and tie rule are the 8-bit model's, in their range.
TEST(KernelsTest, FixedTilesDrawTheCanonicalModelOfEightBits) {
  const Method* canonical = FindMethod("i64-snap8");
  ASSERT_NE(canonical, nullptr);
  for (int seed = 0; seed < Cases(6); ++seed) {
    // Every second target holds little of triangles that are large.
    const bool tiny = seed % 2 == 1;
    OwnedScene owned = RandomScene(static_cast<std::uint64_t>(100 + seed), tiny ? 3 : 130,
                                   tiny ? 2 : 50, tiny ? 400 : 100);
    Scene scene;
    scene.width = owned.width;
    scene.height = owned.height;
    for (KernelVertex& v : owned.vertices) {
      if (tiny) v = {v.x * 500, v.y * 900, v.z};
      v.x = std::isfinite(v.x) ? std::fmax(-kFixedRange, std::fmin(v.x, kFixedRange)) : 0;
      v.y = std::isfinite(v.y) ? std::fmax(-kFixedRange, std::fmin(v.y, kFixedRange)) : 0;
      scene.vertices.push_back({.x = v.x, .y = v.y});
    }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(owned.indices.size()); i += 3) {
      scene.triangles.push_back({i, i + 1, i + 2});
    }
    CoverageCounts expected(scene.width, scene.height);
    Rasterize(scene, *canonical, {}, expected);
    std::vector<std::uint64_t> pixels;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      pixels.push_back(expected.front[i] | std::uint64_t{expected.back[i]} << 32);
    }
    for (const Target target : SupportedTargets()) {
      Surface surface(Sink::kFacing, scene.width, scene.height);
      Draw(KernelMethod::kFixedTiles, target, owned.View(), surface);
      EXPECT_EQ(FirstDifference(surface, pixels), "") << NameOf(target) << ' ' << owned.name;
    }
  }
}

TEST(KernelsTest, WhatThereIsNoKernelForIsRefused) {
  const OwnedScene scene = RandomScene(7, 9, 9, 1);
  Surface counts(Sink::kCount8, 9, 9);
  EXPECT_THROW(Draw(KernelMethod::kMaskRows, Target::kScalar, scene.View(), counts), InputError);
  Surface small(Sink::kCount8, 8, 9);
  EXPECT_THROW(Draw(KernelMethod::kTiles, Target::kScalar, scene.View(), small), InputError);
}

TEST(KernelsTest, TheScalarTargetRunsEverywhere) {
  ASSERT_FALSE(SupportedTargets().empty());
  EXPECT_EQ(SupportedTargets().front(), Target::kScalar);
}

}  // namespace
}  // namespace rasterproof::reference::kernels
