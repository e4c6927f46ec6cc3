// Spans that were found before, only written: what a sink costs with nothing to find out.
#ifndef RASTERPROOF_LIBRARY_KERNELS_KNOWN_SPANS_H_
#define RASTERPROOF_LIBRARY_KERNELS_KNOWN_SPANS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Planes of triangles in order, set up a vector at a time as the kernels do.
class KnownPlanes {
 public:
  HWY_INLINE explicit KnownPlanes(const KernelView& view) : view_(view) {}

  HWY_INLINE Plane Of(std::uint32_t triangle) {
    if (triangle >= end_) SetUp(triangle);
    return block_.PlaneOf(static_cast<int>(triangle % kLanes));
  }

 private:
  HWY_INLINE void SetUp(std::uint32_t triangle) {
    const std::uint32_t first = triangle - triangle % kLanes;
    end_ = first + kLanes;
    const std::uint32_t* indices = view_.indices + std::size_t{3} * first;
    std::uint32_t last[3 * kLanes] = {};
    if (view_.triangles < end_) {
      for (std::size_t k = 0; k < 3 * (view_.triangles - first); ++k) last[k] = indices[k];
      indices = last;
    }
    StorePlanes(DF(), LoadCorners<true>(DF(), view_.vertices, indices), 0, block_);
  }

  const KernelView& view_;
  std::uint32_t end_ = 0;
  Block block_ = {};
};

/// Writes view.known. Small triangles and rows go into the sink as those of the exact kernel do.
template <class Sink>
void DrawKnown(const KernelView& view) {
  Sink sink(view);
  KnownPlanes planes(view);
  const KnownRows* rows = view.known->rows;
  for (std::size_t k = 0; k < view.known->count; ++k) {
    const KnownTriangle& t = view.known->triangles[k];
    if constexpr (Sink::kNeedsPlane) {
      sink.Begin(t.triangle, t.is_front, planes.Of(t.triangle));
    } else {
      sink.Begin(t.triangle, t.is_front, Plane{});
    }
    if (t.rows == 0) {
      sink.Mask8x8(t.x, t.y, t.bits);
      continue;
    }
    constexpr int kStep = Sink::kTakesRows ? kLanes : kKnownRows;
    for (int row = 0; row < t.rows; row += kStep) {
      const KnownRows& group = rows[row / kKnownRows];
      const std::int32_t* first = group.first + row % kKnownRows;
      const std::int32_t* last = group.last + row % kKnownRows;
      const int count = Least(kStep, t.rows - row);
      if constexpr (Sink::kTakesRows) {
        EmitRows(sink, t.width, t.y + row, count, hn::Load(DI(), first), hn::Load(DI(), last));
      } else {
        Emit(sink, t.width, t.y + row, count, first, last);
      }
    }
    rows += (t.rows + kKnownRows - 1) / kKnownRows;
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_KNOWN_SPANS_H_
