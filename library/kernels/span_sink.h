// A sink of the exact kernel (sinks.h) that keeps nothing: each span goes to a function.
#ifndef RASTERPROOF_LIBRARY_KERNELS_SPAN_SINK_H_
#define RASTERPROOF_LIBRARY_KERNELS_SPAN_SINK_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Calls view.on_span once for each row of a triangle that is covered: an exact row is one run.
class SpanSink {
 public:
  static constexpr bool kNeedsPlane = false;
  static constexpr bool kNeedsFacing = true;
  static constexpr bool kTakesRows = false;

  HWY_INLINE explicit SpanSink(const KernelView& view)
      : on_span_(view.on_span), state_(view.state) {}
  template <class P>
  HWY_INLINE void Begin(std::uint32_t triangle, bool is_front, const P& /*plane*/) {
    span_.triangle = triangle;
    span_.is_front = is_front;
  }
  HWY_INLINE void Span(int row, int x0, int x1) {
    span_.row = row;
    span_.x0 = x0;
    span_.x1 = x1;
    on_span_(state_, span_);
  }
  template <int kMost>
  HWY_INLINE void ShortSpan(int row, int x0, int n) {
    if (n > 0) Span(row, x0, x0 + n);
  }
  HWY_INLINE void Mask8x8(int x, int y, std::uint64_t bits) {
    for (int row = y; bits != 0; ++row, bits >>= 8) {
      const std::uint64_t columns = bits & 0xff;
      if (columns == 0) continue;
      const int first = CountTrailingZeros(columns);
      Span(row, x + first, x + first + CountTrailingZeros(~(columns >> first)));
    }
  }

 private:
  void (*on_span_)(const void*, const KernelSpan&);
  const void* state_;
  KernelSpan span_ = {};
};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_SPAN_SINK_H_
