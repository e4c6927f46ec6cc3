// What vectorised contenders share: they draw indexed triangles onto a kernel's surface.
#ifndef RASTERPROOF_BENCH_SURFACE_CONTENDER_H_
#define RASTERPROOF_BENCH_SURFACE_CONTENDER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bench/contender.h"
#include "bench/family.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {

/// Bits of a pixel of the sink.
std::uint64_t BitsOf(library::kernels::Sink sink);

class SurfaceContender : public Contender {
 public:
  SurfaceContender(library::kernels::Target target, library::kernels::Sink sink);

  void Load(const FamilyInput& family) override;
  DrawTime Draw() override;
  DrawTime DrawForNothing() override;
  bool NeedsClearing() const override;
  bool MoveDrawn(CoverageCounts& to) override;
  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override;
  std::vector<std::uint8_t> CoverAlone(std::span<const std::size_t> triangles,
                                       const PixelRect& target, Pixel at) override;
  std::vector<PixelValues> ValuesAlone(std::size_t triangle,
                                       std::span<const Pixel> pixels) override;
  std::uint64_t LeftBehind() override;

 protected:
  /// What every draw of the whole family does first, timed; done at Load(), too.
  virtual void Prepare() {}
  /// Draws these triangles of the loaded family.
  virtual void DrawTriangles(std::span<const std::uint32_t> indices,
                             library::kernels::Surface& surface) = 0;

  const FamilyInput& family() const { return *family_; }
  library::kernels::Target target() const { return target_; }
  library::kernels::Sink sink() const { return sink_; }

 private:
  std::span<const std::uint32_t> IndicesOf(std::size_t triangle) const {
    return std::span(family_->indices).subspan(3 * triangle, 3);
  }

  library::kernels::Target target_;
  library::kernels::Sink sink_;
  const FamilyInput* family_ = nullptr;
  std::shared_ptr<library::kernels::Surface> surface_;
  std::shared_ptr<library::kernels::Surface> alone_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_SURFACE_CONTENDER_H_
