// The rivals of the exact kernel against plain definitions of them, by every sink and target.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "tests/library/clip_scenes.h"
#include "tests/library/drawn_scenes.h"
#include "tests/library/kernel_definitions.h"
#include "tests/library/rival_definitions.h"
#include "tests/share.h"

namespace rasterproof::library::rivals {
namespace {

using kernels::DefineSurface;
using kernels::DrawnScenes;
using kernels::FirstDifference;
using kernels::KernelScene;
using kernels::KernelVertex;
using kernels::kSinks;
using kernels::OwnedScene;
using kernels::RandomScene;
using kernels::Sink;
using kernels::SupportedTargets;
using kernels::Surface;
using kernels::Target;

TEST(RivalsTest, EveryRivalSinkAndTargetDrawsItsDefinition) {
  for (const OwnedScene& scene : DrawnScenes(Cases(100))) {
    const KernelScene view = scene.View();
    for (const Rival& rival : kRivals) {
      if (rival == kTwin) continue;  // which states nothing
      for (const Sink sink : kSinks) {
        if (!Draws(rival, Target::kScalar, sink)) continue;
        const auto expected = DefineSurface(sink, view, [&](const KernelTriangle& t) {
          return Define(rival, t, view.width, view.height);
        });
        for (const Target target : SupportedTargets()) {
          if (!Draws(rival, target, sink)) continue;
          Surface surface(sink, scene.width, scene.height);
          Draw(rival, target, view, surface);
          EXPECT_EQ(FirstDifference(surface, expected), "")
              << scene.name << ' ' << NameOf(rival) << ' ' << NameOf(sink) << ' ' << NameOf(target);
        }
      }
    }
  }
}

// What Surface::At returns of a drawing by the definition, into masks or counts by facing.
std::vector<std::uint64_t> DefineHomogeneousSurface(Sink sink,
                                                    const kernels::OwnedClipScene& scene) {
  std::vector<std::uint64_t> pixels(static_cast<std::size_t>(scene.width) *
                                    static_cast<std::size_t>(scene.height));
  for (std::size_t t = 0; 3 * t < scene.indices.size(); ++t) {
    const Covered covered = definitions::Homogeneous(scene.Corners(t), scene.width, scene.height);
    for (const auto& [x, y] : covered.pixels) {
      std::uint64_t& pixel = pixels[static_cast<std::size_t>(y * scene.width + x)];
      pixel = sink == Sink::kMask ? 1 : pixel + (covered.is_front ? 1 : std::uint64_t{1} << 32);
    }
  }
  return pixels;
}

TEST(RivalsTest, TheRivalOfClipSpaceDrawsItsDefinition) {
  std::uint64_t covered = 0;
  for (int seed = 0; seed < Cases(60); ++seed) {
    // Small ones, too, of a box within 8x8.
    const auto scene = kernels::RandomClipScene(static_cast<std::uint64_t>(seed),
                                                seed % 3 == 0 ? 7 : 20 + 13 * (seed % 9), 61);
    for (const Sink sink : {Sink::kMask, Sink::kFacing}) {
      const auto expected = DefineHomogeneousSurface(sink, scene);
      covered += static_cast<std::uint64_t>(
          std::ranges::count_if(expected, [](std::uint64_t pixel) { return pixel != 0; }));
      for (const Target target : SupportedTargets()) {
        if (!DrawsHomogeneous(target, sink)) continue;
        Surface surface(sink, scene.width, scene.height);
        DrawHomogeneous(target, scene.View(), surface);
        EXPECT_EQ(FirstDifference(surface, expected), "")
            << seed << ' ' << NameOf(sink) << ' ' << NameOf(target);
      }
    }
  }
  EXPECT_GT(covered, 500 * static_cast<std::uint64_t>(Cases(60)));
}

// What EveryRivalSinkAndTargetDrawsItsDefinition is to find: of each rival that is planted in.
TEST(RivalsTest, ASpanOneSampleShortAndASkippedSampleAreNoDefinition) {
  const OwnedScene scene = RandomScene(3, 60, 40, 12);
  const KernelScene view = scene.View();
  for (const Rival& rival : kRivals) {
    if (rival == kTwin || !Draws(rival, WidestTarget(), Sink::kFacing)) continue;
    Surface surface(Sink::kFacing, scene.width, scene.height);
    Draw(rival, WidestTarget(), view, surface);
    for (const bool is_every_row : {true, false}) {
      const auto planted = DefineSurface(Sink::kFacing, view, [&](const KernelTriangle& t) {
        Covered covered = Define(rival, t, view.width, view.height);
        if (covered.pixels.empty()) return covered;
        if (!is_every_row) {
          covered.pixels.erase(covered.pixels.begin() +
                               static_cast<std::ptrdiff_t>(covered.pixels.size() / 2));
          return covered;
        }
        // The last sample of each row.
        std::map<int, int> last;
        for (const auto& [x, y] : covered.pixels) last[y] = std::max(last[y], x);
        std::erase_if(covered.pixels, [&](const auto& at) { return last[at.second] == at.first; });
        return covered;
      });
      EXPECT_NE(FirstDifference(surface, planted), "") << NameOf(rival) << ' ' << is_every_row;
    }
  }
}

// The lower end of the shared edge lies on a pixel's centre's column, an ulp below its row. In
// float32 the row's crossing is rounded beyond it, which the left triangle's box does not hold.
TEST(RivalsTest, SpansOfFloat32LeaveAPixelToNeitherTriangleAtAnEdgeAndThoseOfFloat64DoNot) {
  OwnedScene scene = RandomScene(1, 128, 128, 0);
  scene.vertices = {{-0x1.e246d8p+6F, -0x1.919304p+7F, 0},
                    {0x1.16p+6F, 0x1.6a0002p+6F, 0},
                    {-900, 300, 0},
                    {900, 300, 0}};
  scene.indices = {0, 1, 2, 1, 0, 3};
  for (const Arithmetic arithmetic : {Arithmetic::kFloat32Direct, Arithmetic::kFloat64Direct}) {
    Surface surface(Sink::kFacing, 128, 128);
    const Rival rival{Traversal::kSpans, arithmetic};
    Draw(rival, WidestTarget(), scene.View(), surface);
    const std::uint64_t both = surface.At(69, 90);
    const std::uint64_t drawn = (both & 0xffffffffU) + (both >> 32);
    EXPECT_EQ(drawn, arithmetic == Arithmetic::kFloat64Direct ? 1U : 0U) << NameOf(rival);
  }
}

TEST(RivalsTest, EachHasANameAndDrawsMasks) {
  std::set<std::string> names;
  for (const Rival& rival : kRivals) {
    EXPECT_TRUE(names.insert(NameOf(rival)).second) << NameOf(rival);
    EXPECT_EQ(FindRival(NameOf(rival)), rival);
    EXPECT_TRUE(Draws(rival, WidestTarget(), Sink::kMask)) << NameOf(rival);
    const bool has_facing = rival.traversal != Traversal::kMaskTiles;
    EXPECT_EQ(Draws(rival, WidestTarget(), Sink::kFacing), has_facing) << NameOf(rival);
  }
  EXPECT_EQ(FindRival("spans"), std::nullopt);
}

TEST(RivalsTest, WhatThereIsNoKernelForIsRefused) {
  const OwnedScene scene = RandomScene(7, 9, 9, 1);
  const Rival masks{Traversal::kMaskTiles, Arithmetic::kFloat32Direct};
  Surface facings(Sink::kFacing, 9, 9);
  EXPECT_THROW(Draw(masks, Target::kScalar, scene.View(), facings), InputError);
  Surface small(Sink::kMask, 8, 9);
  EXPECT_THROW(Draw(masks, Target::kScalar, scene.View(), small), InputError);
}

// The tiles' snap and tie rule are the 8-bit model's, in their range.
TEST(RivalsTest, FixedTilesDrawTheCanonicalModelOfEightBits) {
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
    for (const Arithmetic arithmetic : {Arithmetic::kInt32, Arithmetic::kInt64}) {
      const Rival rival{Traversal::kTiles, arithmetic};
      for (const Target target : SupportedTargets()) {
        if (!Draws(rival, target, Sink::kFacing)) continue;
        Surface surface(Sink::kFacing, scene.width, scene.height);
        Draw(rival, target, owned.View(), surface);
        EXPECT_EQ(FirstDifference(surface, pixels), "")
            << NameOf(rival) << ' ' << NameOf(target) << ' ' << owned.name;
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::library::rivals
