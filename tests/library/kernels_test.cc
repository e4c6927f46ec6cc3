// The kernels against plain definitions of them, by every sink and target.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.h"
#include "library/kernels/kernel.h"
#include "tests/library/drawn_scenes.h"
#include "tests/library/kernel_definitions.h"
#include "tests/share.h"

namespace rasterproof::library::kernels {
namespace {

TEST(KernelsTest, EverySinkAndTargetDrawsTheDefinition) {
  for (const OwnedScene& scene : DrawnScenes(Cases(100))) {
    const KernelScene view = scene.View();
    for (const Sink sink : kSinks) {
      const auto expected = DefineSurface(sink, view, [&](const KernelTriangle& t) {
        return definitions::Exact(t, view.width, view.height);
      });
      for (const Target target : SupportedTargets()) {
        Surface surface(sink, scene.width, scene.height);
        Draw(target, view, surface);
        EXPECT_EQ(FirstDifference(surface, expected), "")
            << scene.name << ' ' << NameOf(sink) << ' ' << NameOf(target);
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
        Draw(target, scene, counts);
        Draw(target, scene, mask);
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
  for (const Sink sink : kSinks) {
    if (sink == Sink::kId) continue;
    for (const Target target : SupportedTargets()) {
      Surface whole(sink, 67, 35);
      Draw(target, view, whole);
      Surface halves(sink, 67, 35);
      const std::size_t middle = 3 * 17;
      KernelScene part = view;
      part.indices = view.indices.first(middle);
      Draw(target, part, halves);
      part.indices = view.indices.subspan(middle);
      Draw(target, part, halves);
      for (int y = 0; y < 35; ++y) {
        for (int x = 0; x < 67; ++x) ASSERT_EQ(halves.At(x, y), whole.At(x, y));
      }
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
  Surface small(Sink::kCount8, 8, 9);
  EXPECT_THROW(Draw(Target::kScalar, scene.View(), small), InputError);
}

TEST(KernelsTest, TheScalarTargetRunsEverywhere) {
  ASSERT_FALSE(SupportedTargets().empty());
  EXPECT_EQ(SupportedTargets().front(), Target::kScalar);
}

}  // namespace
}  // namespace rasterproof::library::kernels
