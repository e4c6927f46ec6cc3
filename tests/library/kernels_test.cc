// The kernels against plain definitions of them, by every method, sink and target.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "library/kernels/kernel.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "tests/library/drawn_scenes.h"
#include "tests/library/kernel_definitions.h"
#include "tests/share.h"

namespace rasterproof::library::kernels {
namespace {

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
  for (const OwnedScene& scene : DrawnScenes(Cases(100))) {
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

// Rows of every width up to 60 from every bit of a byte on, in triangles of every path.
TEST(KernelsTest, MasksEqualCountsAtEveryBit) {
  for (const Target target : SupportedTargets()) {
    Surface counts(Sink::kCount8, 160, 90);
    Surface mask(Sink::kMask, 160, 90);
    for (int width = 1; width <= 60; ++width) {
      for (int x = 0; x < 16; ++x) {
        const float height = static_cast<float>(x % 2 == 0 ? 40 : 88);
        const auto left = static_cast<float>(x);
        const auto right = static_cast<float>(x + width);
        const std::array<KernelVertex, 3> vertices{
            {{left, 0.25F, 0}, {right, 0.25F, 0}, {left + 30, height, 0}}};
        const std::array<std::uint32_t, 3> indices{0, 1, 2};
        const KernelScene scene{vertices, indices, 160, 90};
        counts.Clear();
        mask.Clear();
        Draw(KernelMethod::kExact, target, scene, counts);
        Draw(KernelMethod::kExact, target, scene, mask);
        for (int i = 0; i < 160 * 90; ++i) {
          ASSERT_EQ(mask.At(i % 160, i / 160), counts.At(i % 160, i / 160))
              << NameOf(target) << ' ' << x << ' ' << width << " pixel " << i;
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
  const reference::Method* canonical = reference::FindMethod("i64-snap8");
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

TEST(KernelsTest, FillTakesEveryPixelOnce) {
  const std::array<std::uint64_t, kSinks.size()> filled{1, 1, 1, 7, 0x3f000000};  // 0.5F
  for (const int width : {1, 67, 1920}) {
    for (const Sink sink : kSinks) {
      for (const Target target : SupportedTargets()) {
        Surface surface(sink, width, 9);
        Fill(target, surface);
        const std::uint64_t value = filled[static_cast<std::size_t>(sink)];
        EXPECT_EQ(FirstDifference(surface, std::vector(static_cast<std::size_t>(width) * 9, value)),
                  "")
            << NameOf(sink) << ' ' << NameOf(target) << ' ' << width;
      }
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
}  // namespace rasterproof::library::kernels
