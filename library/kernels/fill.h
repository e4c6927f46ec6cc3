// One pass over a surface: how fast the machine can do what a sink does, with nothing to find out.
#ifndef RASTERPROOF_LIBRARY_KERNELS_FILL_H_
#define RASTERPROOF_LIBRARY_KERNELS_FILL_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Replaces each vector of the target's rows by change(d, old). Rows of bits are not aligned.
template <class T, class Change>
HWY_INLINE void ChangeRows(const KernelView& view, int width, const Change& change) {
  const hn::ScalableTag<T> d;
  T* row = static_cast<T*>(view.planes[0]);
  for (int y = 0; y < view.height; ++y, row += view.pitch) {
    for (int x = 0; x < width; x += kLanesOf<decltype(d)>) {
      hn::StoreU(change(d, hn::LoadU(d, row + x)), d, row + x);
    }
  }
}

inline void FillCount8(const KernelView& view) {
  ChangeRows<std::uint8_t>(view, view.width, [](auto d, auto old) {
    return hn::SaturatedAdd(old, hn::Set(d, std::uint8_t{1}));
  });
}
inline void FillFacing(const KernelView& view) {
  ChangeRows<std::uint32_t>(view, view.width,
                            [](auto d, auto old) { return hn::Add(old, hn::Set(d, 1U)); });
}
inline void FillMask(const KernelView& view) {
  ChangeRows<std::uint8_t>(view, (view.width + 7) / 8,
                           [](auto d, auto /*old*/) { return hn::Set(d, std::uint8_t{0xff}); });
}
inline void FillId(const KernelView& view) {
  ChangeRows<std::uint32_t>(view, view.width, [](auto d, auto /*old*/) { return hn::Set(d, 7U); });
}
inline void FillDepth(const KernelView& view) {
  ChangeRows<float>(view, view.width,
                    [](auto d, auto old) { return hn::Min(old, hn::Set(d, 0.5F)); });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_FILL_H_
