// kTiles: float32 half-spaces over 8x8 tiles.
#ifndef RASTERPROOF_LIBRARY_KERNELS_FLOAT_TILES_H_
#define RASTERPROOF_LIBRARY_KERNELS_FLOAT_TILES_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/float_edges.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/tile_walk.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The edges of one triangle, for WalkTiles. Of tile i of row j, from the first that meets the box:
///   E at its first pixel:  t = (e + 8 j b) + 8 i a
///   E at column c, row r:  t + (c a + r b)
///   rejected:              t < least - (7 max(a, 0) + 7 max(b, 0)) for an edge
///   accepted:              t >= least - (7 min(a, 0) + 7 min(b, 0)) for all edges
class FloatTileEdges {
 public:
  static constexpr int kTiles = kLanes;

  HWY_INLINE FloatTileEdges(const FloatBlock& block, int i) {
    const DF d;
    x_ = block.x0[i] & ~7;
    y_ = block.y0[i] & ~7;
    for (int k = 0; k < 3; ++k) {
      e_[k] = EdgeAt(block, k, i, x_, y_);
      a_[k] = block.a[k][i];
      b_[k] = block.b[k][i];
      least_[k] = block.least[k][i];
      const float zero = 0;
      reject_[k] = least_[k] - (7 * Greatest(a_[k], zero) + 7 * Greatest(b_[k], zero));
      accept_[k] = least_[k] - (7 * Least(a_[k], zero) + 7 * Least(b_[k], zero));
      for (int at = 0; at < 64; at += kLanes) {
        const VF c = hn::Load(d, kColumns + at);
        const VF r = hn::Load(d, kRows + at);
        hn::Store(hn::Add(hn::Mul(c, hn::Set(d, a_[k])), hn::Mul(r, hn::Set(d, b_[k]))), d,
                  offsets_[k] + at);
      }
    }
  }

  HWY_INLINE void BeginRow(int y) {
    for (int k = 0; k < 3; ++k) row_[k] = e_[k] + static_cast<float>(y - y_) * b_[k];
  }

  HWY_INLINE void Classify(int i, std::uint32_t& any, std::uint32_t& full) const {
    const DF d;
    const VF x = hn::Mul(FloatsFrom(d, static_cast<float>(i)), hn::Set(d, 8.0F));
    VF t[3];
    for (int k = 0; k < 3; ++k) t[k] = hn::Add(hn::Set(d, row_[k]), hn::Mul(x, hn::Set(d, a_[k])));
    any = static_cast<std::uint32_t>(MaskBits(d, AllReach(t, reject_)));
    full = static_cast<std::uint32_t>(MaskBits(d, AllReach(t, accept_)));
  }

  HWY_INLINE std::uint64_t Pixels(int i) const {
    const DF d;
    VF t[3];
    for (int k = 0; k < 3; ++k) t[k] = hn::Set(d, row_[k] + static_cast<float>(8 * i) * a_[k]);
    std::uint64_t bits = 0;
    for (int at = 0; at < 64; at += kLanes) {
      VF e[3];
      for (int k = 0; k < 3; ++k) e[k] = hn::Add(t[k], hn::Load(d, offsets_[k] + at));
      bits |= MaskBits(d, AllReach(e, least_)) << at;
    }
    return bits;
  }

 private:
  HWY_INLINE static hn::Mask<DF> AllReach(const VF (&v)[3], const float (&least)[3]) {
    const DF d;
    return hn::And(hn::And(hn::Ge(v[0], hn::Set(d, least[0])), hn::Ge(v[1], hn::Set(d, least[1]))),
                   hn::Ge(v[2], hn::Set(d, least[2])));
  }

  alignas(64) float offsets_[3][64];
  int x_, y_;
  float e_[3], a_[3], b_[3], least_[3], reject_[3], accept_[3];
  float row_[3];
};

template <class Sink>
void DrawFloatTiles(const KernelView& view) {
  Sink sink(view);
  FloatBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpFloatEdges<Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallMasks<false>(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          const std::uint64_t bits = block.masks[i] & SmallBoxMask(block, i);
          if (bits != 0) sink.Mask8x8(block.x0[i], block.y0[i], bits);
        } else {
          FloatTileEdges edges(block, i);
          WalkTiles(edges, block.BoxOf(i), sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_FLOAT_TILES_H_
