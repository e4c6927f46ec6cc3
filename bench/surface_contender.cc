#include "bench/surface_contender.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

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

SurfaceContender::SurfaceContender(kernels::Target target, kernels::Sink sink)
    : target_(target), sink_(sink) {
  method_.target = NameOf(target);
  method_.sink = NameOf(sink);
  method_.pixel_bits = BitsOf(sink);
}

void SurfaceContender::Load(const FamilyInput& family) {
  family_ = &family;
  surface_.emplace(sink_, family.scene.width, family.scene.height);
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

std::optional<CoverageCounts> SurfaceContender::Drawn() {
  if (sink_ != kernels::Sink::kFacing) return std::nullopt;
  CoverageCounts counts(surface_->width(), surface_->height());
  for (int y = 0; y < surface_->height(); ++y) {
    for (int x = 0; x < surface_->width(); ++x) {
      const std::uint64_t both = surface_->At(x, y);
      const std::size_t i = counts.Index(x, y);
      counts.front[i] = static_cast<std::uint32_t>(both);
      counts.back[i] = static_cast<std::uint32_t>(both >> 32);
    }
  }
  surface_->Clear();
  return counts;
}

// By every instruction set and into every sink the same: tests/library/kernels_test.cc.
void SurfaceContender::DrawAlone(std::size_t triangle, const PixelRect& area,
                                 std::vector<std::uint8_t>& box) {
  if (!alone_) alone_.emplace(kernels::Sink::kFacing, surface_->width(), surface_->height());
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
    for (int x = 0; x < alone_->width(); ++x) left += alone_->At(x, y) != 0 ? 1 : 0;
  }
  alone_.reset();
  return left;
}

}  // namespace rasterproof::bench
