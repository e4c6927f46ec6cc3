// Meshes in clip space: what the library draws is what the kernel draws, which clip_kernel_test
// holds against the oracle.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.h"
#include "library/kernels/kernel.h"
#include "library/rasterize.h"
#include "library/rasterproof_rasterize.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

namespace kernels = library::kernels;

constexpr int kClipWidth = 75;
constexpr int kClipHeight = 31;

struct ClipMesh {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;

  RasterMesh In(RasterSpace space) const { return {positions, indices, space}; }
  kernels::ClipScene Scene(kernels::NearPlane near_plane) const {
    static_assert(sizeof(kernels::ClipVertex) == 4 * sizeof(float));
    return {{reinterpret_cast<const kernels::ClipVertex*>(positions.data()), positions.size() / 4},
            indices,
            kClipWidth,
            kClipHeight,
            near_plane};
  }
};

ClipMesh RandomClipMesh(std::uint64_t seed) {
  reference::RandomValues random(seed);
  ClipMesh mesh;
  for (std::uint32_t k = 0; k < 3 * 40; ++k) {
    const double w = random.Uniform(-0.5, 2);
    for (const double v : {random.Uniform(-20, 95) * w, random.Uniform(-20, 50) * w,
                           random.Uniform(-0.5, 1) * w, w}) {
      mesh.positions.push_back(static_cast<float>(v));
    }
    mesh.indices.push_back(k);
  }
  return mesh;
}

struct Kept {
  RasterOutput output;
  kernels::Sink sink;
  std::size_t row;  // bytes
};
constexpr std::array<Kept, 4> kClipKept{
    {{RasterOutput::kCounts, kernels::Sink::kCount8, kClipWidth},
     {RasterOutput::kMask, kernels::Sink::kMask, 10},
     {RasterOutput::kIds, kernels::Sink::kId, 4 * kClipWidth},
     {RasterOutput::kDepths, kernels::Sink::kDepth, 4 * kClipWidth}}};
struct Space {
  RasterSpace space;
  kernels::NearPlane near_plane;
};
constexpr std::array<Space, 3> kClipSpaces{
    {{RasterSpace::kClip, kernels::NearPlane::kNone},
     {RasterSpace::kClipNearZero, kernels::NearPlane::kZero},
     {RasterSpace::kClipNearMinusW, kernels::NearPlane::kMinusW}}};

void ExpectRows(const std::vector<std::byte>& memory, const Kept& kept, kernels::Surface& surface,
                const std::string& name) {
  const std::size_t unit = kept.row / kClipWidth == 4 ? 4 : 1;
  for (int y = 0; y < kClipHeight; ++y) {
    const std::byte* const expected =
        surface.plane(0) + static_cast<std::size_t>(y * surface.pitch()) * unit;
    const std::byte* const row = memory.data() + static_cast<std::size_t>(y) * kept.row;
    const bool is_mask = kept.sink == kernels::Sink::kMask;
    ASSERT_EQ(std::memcmp(row, expected, is_mask ? kClipWidth / 8 : kept.row), 0)
        << name << " row " << y;
    constexpr auto kLast = static_cast<std::byte>((1 << kClipWidth % 8) - 1);
    if (is_mask) {
      ASSERT_EQ(row[kept.row - 1] & kLast, expected[kept.row - 1] & kLast) << name;
    }
  }
}

// With no room after the rows, by one thread and by three.
TEST(RasterizeClip, DrawsWhatTheKernelDraws) {
  RasterWorkers workers(3);
  for (int i = 0; i < Cases(20); ++i) {
    const ClipMesh mesh = RandomClipMesh(static_cast<std::uint64_t>(i));
    for (const auto& [space, near_plane] : kClipSpaces) {
      for (const Kept& kept : kClipKept) {
        kernels::Surface surface(kept.sink, kClipWidth, kClipHeight);
        kernels::DrawClip(kernels::Target::kScalar, mesh.Scene(near_plane), surface);
        std::vector<std::byte> memory(kept.row * kClipHeight);
        const RasterTarget target{.output = kept.output,
                                  .width = kClipWidth,
                                  .height = kClipHeight,
                                  .pitch = kept.row,
                                  .memory = memory};
        Clear(target);
        Rasterize(mesh.In(space), target);
        ExpectRows(memory, kept, surface, "one thread");
        Clear(target);
        workers.Rasterize(mesh.In(space), target);
        ExpectRows(memory, kept, surface, "three threads");
      }
    }
  }
}

TEST(RasterizeClip, GivesSpansAndMarksWhatCoversNothing) {
  const ClipMesh mesh = RandomClipMesh(99);
  kernels::Surface ids(kernels::Sink::kId, kClipWidth, kClipHeight);
  kernels::DrawClip(kernels::Target::kScalar, mesh.Scene(kernels::NearPlane::kZero), ids);
  kernels::Surface facing(kernels::Sink::kFacing, kClipWidth, kClipHeight);
  kernels::DrawClip(kernels::Target::kScalar, mesh.Scene(kernels::NearPlane::kZero), facing);
  std::vector<std::uint64_t> counts(std::size_t{kClipWidth} * kClipHeight);
  std::vector<std::uint32_t> drawn(std::size_t{kClipWidth} * kClipHeight, kNoTriangle);
  std::vector<std::uint8_t> covers_nothing(mesh.indices.size() / 3, 1);
  Rasterize(mesh.In(RasterSpace::kClipNearZero), kClipWidth, kClipHeight,
            [&](const RasterSpan& span) {
              covers_nothing[span.triangle] = 0;
              for (int x = span.x0; x < span.x1; ++x) {
                const auto at = static_cast<std::size_t>(span.y * kClipWidth + x);
                drawn[at] = span.triangle;
                counts[at] += span.is_front ? 1 : std::uint64_t{1} << 32;
              }
            });
  for (int y = 0; y < kClipHeight; ++y) {
    for (int x = 0; x < kClipWidth; ++x) {
      const auto at = static_cast<std::size_t>(y * kClipWidth + x);
      ASSERT_EQ(drawn[at], ids.At(x, y));
      ASSERT_EQ(counts[at], facing.At(x, y));
    }
  }
  std::vector<std::uint8_t> is_empty(covers_nothing.size());
  MarkEmptyTriangles(mesh.In(RasterSpace::kClipNearZero), kClipWidth, kClipHeight, is_empty);
  EXPECT_EQ(is_empty, covers_nothing);
}

std::string Refused(const RasterMesh& mesh, RasterOutput output) {
  std::array<std::byte, 64> memory{};
  try {
    Rasterize(mesh, {.output = output, .width = 8, .height = 8, .pitch = 8, .memory = memory});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RasterizeClip, RefusesWhatItCannotDraw) {
  const ClipMesh mesh = RandomClipMesh(1);
  EXPECT_EQ(Refused(mesh.In(RasterSpace::kClip), RasterOutput::kInnerMask),
            "target.output: squares need window space; give a mesh of window space, or ask "
            "for an output of centres");
  RasterMesh odd = mesh.In(RasterSpace::kClip);
  odd.positions = odd.positions.first(15);
  EXPECT_EQ(Refused(odd, RasterOutput::kMask), "mesh.positions: 15 of them; give four of each");
  odd.space = static_cast<RasterSpace>(4);
  EXPECT_EQ(Refused(odd, RasterOutput::kMask),
            "mesh.space: there is no such space; give one of RasterSpace");
  RasterMesh few = mesh.In(RasterSpace::kClip);
  few.positions = few.positions.first(16);
  EXPECT_EQ(Refused(few, RasterOutput::kMask),
            "mesh.indices[4]: 4, and there are 4 vertices; give indices of positions");
}

TEST(RasterizeClip, DoesTheSameInC) {
  const std::array<float, 12> positions{0, 0, 0, 1, 16, 0, 0, 2, 0, 8, -1, 1};
  const std::array<std::uint32_t, 3> indices{0, 1, 2};
  rasterproof_raster_mesh mesh{positions.data(), 3, indices.data(), 1, RASTERPROOF_RASTER_CLIP};
  std::array<std::uint8_t, 64> all{}, near{};
  rasterproof_raster_target target{
      RASTERPROOF_RASTER_COUNTS, 8, 8, 8, all.data(), all.size(), nullptr, 0};
  EXPECT_EQ(rasterproof_rasterize(&mesh, &target, RASTERPROOF_RASTER_BEST), RASTERPROOF_RASTER_OK);
  mesh.space = RASTERPROOF_RASTER_CLIP_NEAR_ZERO;
  target.memory = near.data();
  EXPECT_EQ(rasterproof_rasterize(&mesh, &target, RASTERPROOF_RASTER_BEST), RASTERPROOF_RASTER_OK);
  // The corner at (0, 8) is before the near plane: z is 0 along the first row's edge alone.
  EXPECT_EQ(all[0], 1);
  EXPECT_EQ(all[8 * 6], 1);
  EXPECT_EQ(near, (std::array<std::uint8_t, 64>{}));
  mesh.space = 4;
  EXPECT_EQ(rasterproof_rasterize(&mesh, &target, RASTERPROOF_RASTER_BEST),
            RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(std::string(rasterproof_raster_message()),
            "mesh.space: there is no such space; give one of rasterproof_raster_space");
}

}  // namespace
}  // namespace rasterproof
