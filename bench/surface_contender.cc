#include "bench/surface_contender.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bench/shared_target.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {

namespace kernels = library::kernels;

std::uint64_t BitsOf(kernels::Sink sink) {
  switch (sink) {
    case kernels::Sink::kCount8:
      return 8;
    case kernels::Sink::kFacing:
      return 64;
    case kernels::Sink::kMask:
      return 1;
    case kernels::Sink::kId:
    case kernels::Sink::kDepth:
      return 32;
  }
  return 0;
}

namespace {

std::shared_ptr<kernels::Surface> SurfaceOf(kernels::Sink sink, const Scene& scene,
                                            SharedTarget<kernels::Surface>& shared) {
  return shared.Of(
      [&](const kernels::Surface& surface) {
        return surface.width() == scene.width && surface.height() == scene.height;
      },
      [&] { return kernels::Surface(sink, scene.width, scene.height); });
}

}  // namespace

SurfaceContender::SurfaceContender(kernels::Target target, kernels::Sink sink)
    : target_(target), sink_(sink) {
  method_.target = NameOf(target);
  method_.sink = NameOf(sink);
  method_.pixel_bits = BitsOf(sink);
}

void SurfaceContender::Load(const FamilyInput& family) {
  family_ = &family;
  static thread_local std::array<SharedTarget<kernels::Surface>, kernels::kSinks.size()> shared;
  surface_ = SurfaceOf(sink_, family.scene, shared[static_cast<std::size_t>(sink_)]);
  alone_.reset();
  Prepare();
}

DrawTime SurfaceContender::Draw() {
  surface_->Clear();
  return DrawForNothing();
}

DrawTime SurfaceContender::DrawForNothing() {
  return Timed([&] {
    Prepare();
    DrawTriangles(family_->indices, *surface_);
  });
}

// Counts add up the same on any others; what others hold is compared with.
bool SurfaceContender::NeedsClearing() const {
  return sink_ != kernels::Sink::kFacing && sink_ != kernels::Sink::kCount8;
}

bool SurfaceContender::MoveDrawn(CoverageCounts& to) {
  if (sink_ != kernels::Sink::kFacing) return false;
  const int width = surface_->width();
  const int height = surface_->height();
  if (to.size() != CoverageCounts::Size(width, height, 1)) to = CoverageCounts(width, height);
  to.width = width;
  to.height = height;
  for (int y = 0; y < height; ++y) {
    for (const int facing : {0, 1}) {
      const auto* const row =
          reinterpret_cast<const std::uint32_t*>(surface_->plane(facing)) + y * surface_->pitch();
      std::copy_n(row, width, (facing == 0 ? to.front : to.back).data() + to.Index(0, y));
    }
  }
  return true;
}

// By every instruction set and into every sink the same: tests/library/kernels_test.cc.
void SurfaceContender::DrawAlone(std::size_t triangle, const PixelRect& area,
                                 std::vector<std::uint8_t>& box) {
  if (alone_ == nullptr) {
    static thread_local SharedTarget<kernels::Surface> shared;
    alone_ = SurfaceOf(kernels::Sink::kFacing, family_->scene, shared);
    alone_->Clear();
  }
  DrawTriangles(IndicesOf(triangle), *alone_);
  std::uint8_t* to = box.data();
  for (int y = area.y0; y < area.y1; ++y) {
    std::array<std::uint32_t*, 2> rows{};
    for (int facing = 0; facing < 2; ++facing) {
      rows[static_cast<std::size_t>(facing)] =
          reinterpret_cast<std::uint32_t*>(alone_->plane(facing)) + y * alone_->pitch();
    }
    for (int x = area.x0; x < area.x1; ++x) *to++ = (rows[0][x] | rows[1][x]) != 0 ? 1 : 0;
    for (std::uint32_t* const row : rows) std::fill(row + area.x0, row + area.x1, 0U);
  }
}

std::vector<std::uint8_t> SurfaceContender::CoverAlone(std::span<const std::size_t> triangles,
                                                       const PixelRect& target, Pixel at) {
  if (DrawsAlone()) return Contender::CoverAlone(triangles, target, at);
  std::vector<std::uint8_t> covered;
  for (const std::size_t triangle : triangles) {
    surface_->Clear();
    DrawTriangles(IndicesOf(triangle), *surface_);
    covered.push_back(surface_->At(at.x, at.y) != 0 ? 1 : 0);
  }
  return covered;
}

std::vector<PixelValues> SurfaceContender::ValuesAlone(std::size_t triangle,
                                                       std::span<const Pixel> pixels) {
  std::vector<PixelValues> values;
  if (sink_ != kernels::Sink::kDepth) return values;
  surface_->Clear();
  DrawTriangles(IndicesOf(triangle), *surface_);
  for (const Pixel& at : pixels) {
    const auto bits = static_cast<std::uint32_t>(surface_->At(at.x, at.y));
    const auto depth = double{std::bit_cast<float>(bits)};
    PixelValues& shown = values.emplace_back();
    if (std::isfinite(depth)) shown.depth = depth;
  }
  return values;
}

std::uint64_t SurfaceContender::LeftBehind() {
  std::uint64_t left = 0;
  if (!alone_) return left;
  for (int y = 0; y < alone_->height(); ++y) {
    std::array<const std::uint32_t*, 2> rows{};
    for (const int facing : {0, 1}) {
      rows[static_cast<std::size_t>(facing)] =
          reinterpret_cast<const std::uint32_t*>(alone_->plane(facing)) + y * alone_->pitch();
    }
    for (int x = 0; x < alone_->width(); ++x) left += (rows[0][x] | rows[1][x]) != 0 ? 1 : 0;
  }
  alone_.reset();
  return left;
}

}  // namespace rasterproof::bench
