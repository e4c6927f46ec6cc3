// Edge functions in float32: E(x, y) = (x - vx) a + (y - vy) b, inside where all reach `least`.
#ifndef RASTERPROOF_LIBRARY_KERNELS_FLOAT_EDGES_H_
#define RASTERPROOF_LIBRARY_KERNELS_FLOAT_EDGES_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The smallest normal float: what an edge that does not own its ties must reach.
constexpr float kAboveZero = 0x1p-126F;

struct alignas(64) FloatBlock : Block {
  float vx[3][kBlock], vy[3][kBlock];
  float a[3][kBlock], b[3][kBlock];
  float least[3][kBlock];       ///< 0 for a top or left edge, else kAboveZero
  float e[3][kBlock];           ///< at the centre of the box's first pixel
  std::uint64_t masks[kBlock];  ///< of small ones: coverage of the 8x8 pixels from the box's corner
};

/// The value of an edge function at a pixel centre, each operation rounded.
HWY_INLINE float EdgeAt(const FloatBlock& block, int k, int i, int x, int y) {
  return (static_cast<float>(x) + 0.5F - block.vx[k][i]) * block.a[k][i] +
         (static_cast<float>(y) + 0.5F - block.vy[k][i]) * block.b[k][i];
}

template <bool kWithZ>
HWY_INLINE void SetUpFloatEdges(const KernelView& view, const std::uint32_t* indices,
                                FloatBlock& block) {
  const DF d;
  const DI di;
  const VF zero = hn::Zero(d);
  const VF half = hn::Set(d, 0.5F);
  for (int at = 0; at < kBlock; at += kLanes) {
    Corners<VF> c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    const VI x0 = FirstCentreFrom(d, Min3(c.x), view.width);
    const VI x1 = FirstCentreBeyond(d, Max3(c.x), view.width);
    const VI y0 = FirstCentreFrom(d, Min3(c.y), view.height);
    const VI y1 = FirstCentreBeyond(d, Max3(c.y), view.height);
    const std::uint32_t boxed = StoreBox(di, x0, x1, y0, y1, at, block);
    // Twice the signed area; counter-clockwise on screen from here on.
    const VF area = hn::Sub(hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])),
                            hn::Mul(hn::Sub(c.y[2], c.y[0]), hn::Sub(c.x[1], c.x[0])));
    const auto is_front = hn::Gt(area, zero);
    const auto has_area =
        hn::And(hn::Gt(hn::Abs(area), zero), hn::Lt(hn::Abs(area), hn::Set(d, __builtin_inff())));
    const VF x_one = hn::IfThenElse(is_front, c.x[1], c.x[2]);
    const VF y_one = hn::IfThenElse(is_front, c.y[1], c.y[2]);
    c.x[2] = hn::IfThenElse(is_front, c.x[2], c.x[1]);
    c.y[2] = hn::IfThenElse(is_front, c.y[2], c.y[1]);
    c.x[1] = x_one;
    c.y[1] = y_one;
    const VF x = hn::Add(hn::ConvertTo(d, x0), half);
    const VF y = hn::Add(hn::ConvertTo(d, y0), half);
    for (int k = 0; k < 3; ++k) {
      const int next = k == 2 ? 0 : k + 1;
      const VF a = hn::Sub(c.y[next], c.y[k]);
      const VF b = hn::Sub(c.x[k], c.x[next]);
      const auto owns_ties = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
      hn::Store(c.x[k], d, block.vx[k] + at);
      hn::Store(c.y[k], d, block.vy[k] + at);
      hn::Store(a, d, block.a[k] + at);
      hn::Store(b, d, block.b[k] + at);
      hn::Store(hn::IfThenElse(owns_ties, zero, hn::Set(d, kAboveZero)), d, block.least[k] + at);
      hn::Store(hn::Add(hn::Mul(hn::Sub(x, c.x[k]), a), hn::Mul(hn::Sub(y, c.y[k]), b)), d,
                block.e[k] + at);
    }
    block.front |= static_cast<std::uint32_t>(MaskBits(d, is_front)) << at;
    block.drawn |= (static_cast<std::uint32_t>(MaskBits(d, has_area)) & boxed) << at;
  }
  FindSmall(block);
}

/// Fills in the masks of the small triangles, kLanes at a time, pixel by pixel of the largest box.
/// The value at column c and row r of the box: stepped, e + b + ... + b + a + ... + a; otherwise
/// (e + r b) + c a.
template <bool kStepped>
HWY_INLINE void FindSmallMasks(FloatBlock& block) {
  const DF d;
  const DU du;
  for (int at = 0; at < kBlock; at += kLanes) {
    if (((block.small >> at) & ((std::uint64_t{1} << kLanes) - 1)) == 0) continue;
    VF row[3], a[3], b[3], least[3], columns[3][8];
    for (int k = 0; k < 3; ++k) {
      row[k] = hn::Load(d, block.e[k] + at);
      a[k] = hn::Load(d, block.a[k] + at);
      b[k] = hn::Load(d, block.b[k] + at);
      least[k] = hn::Load(d, block.least[k] + at);
      if constexpr (!kStepped) {
        for (int c = 0; c < block.width; ++c) {
          columns[k][c] = hn::Mul(a[k], hn::Set(d, static_cast<float>(c)));
        }
      }
    }
    VU halves[2] = {hn::Zero(du), hn::Zero(du)};
    for (int r = 0; r < block.height; ++r) {
      VF e[3];
      for (int k = 0; k < 3; ++k) {
        if constexpr (kStepped) {
          e[k] = row[k];
          row[k] = hn::Add(row[k], b[k]);
        } else {
          row[k] = hn::Add(hn::Load(d, block.e[k] + at),
                           hn::Mul(b[k], hn::Set(d, static_cast<float>(r))));
        }
      }
      VU bits = hn::Zero(du);
      for (int c = 0; c < block.width; ++c) {
        if constexpr (!kStepped) {
          for (int k = 0; k < 3; ++k) e[k] = hn::Add(row[k], columns[k][c]);
        }
        const auto inside = hn::And(hn::And(hn::Ge(e[0], least[0]), hn::Ge(e[1], least[1])),
                                    hn::Ge(e[2], least[2]));
        const VU bit = hn::Set(du, std::uint32_t{1} << (8 * (r & 3) + c));
        bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(du, inside), bit));
        if constexpr (kStepped) {
          for (int k = 0; k < 3; ++k) e[k] = hn::Add(e[k], a[k]);
        }
      }
      if (r < 4) {
        halves[0] = hn::Or(halves[0], bits);
      } else {
        halves[1] = hn::Or(halves[1], bits);
      }
    }
    alignas(64) std::uint32_t low[kLanes], high[kLanes];
    hn::Store(halves[0], du, low);
    hn::Store(halves[1], du, high);
    for (int i = 0; i < kLanes; ++i) {
      block.masks[at + i] = std::uint64_t{low[i]} | (std::uint64_t{high[i]} << 32);
    }
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_FLOAT_EDGES_H_
