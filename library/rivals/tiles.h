// Traversal::kTiles in float32 and float64.
#ifndef RASTERPROOF_LIBRARY_RIVALS_TILES_H_
#define RASTERPROOF_LIBRARY_RIVALS_TILES_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/edges.h"
#include "library/rivals/reals.h"
#include "library/rivals/tile_walk.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The edges of one triangle, for WalkTiles. Of tile i of row j, from the first that meets the box,
/// with t the value at its first pixel:
///   stepped   t = (e + 8 j b) + 8 i a; at column c, row r: t + (c a + r b)
///   others    the column's share and the row's, for t as for each pixel
///   rejected  t < least - (7 max(a, 0) + 7 max(b, 0)) for an edge
///   accepted  t >= least - (7 min(a, 0) + 7 min(b, 0)) for all edges
template <class T, Form kForm>
class RealTileEdges {
 public:
  static constexpr int kTiles = kReals<T>;

  HWY_INLINE RealTileEdges(const EdgeBlock<T>& block, int i) {
    const RealTag<T> d;
    x_ = block.x0[i] & ~7;
    y_ = block.y0[i] & ~7;
    for (int k = 0; k < 3; ++k) {
      a_[k] = block.a[k][i];
      b_[k] = block.b[k][i];
      least_[k] = block.least[k][i];
      const T zero = 0;
      reject_[k] = least_[k] - (7 * Greatest(a_[k], zero) + 7 * Greatest(b_[k], zero));
      accept_[k] = least_[k] - (7 * Least(a_[k], zero) + 7 * Least(b_[k], zero));
      if constexpr (kForm == Form::kStepped) {
        e_[k] = block.At(k, i, x_, y_);
        for (int at = 0; at < 64; at += kReals<T>) {
          const V c = LoadReals<T>(kColumns + at);
          const V r = LoadReals<T>(kRows + at);
          hn::Store(hn::Add(hn::Mul(c, hn::Set(d, a_[k])), hn::Mul(r, hn::Set(d, b_[k]))), d,
                    offsets_[k] + at);
        }
      } else {
        e_[k] = kForm == Form::kAffine ? block.c[k][i] : block.vy[k][i];
        vx_[k] = block.vx[k][i];
      }
    }
  }

  HWY_INLINE void BeginRow(int y) {
    const RealTag<T> d;
    for (int k = 0; k < 3; ++k) {
      if constexpr (kForm == Form::kStepped) {
        row_[k] = e_[k] + static_cast<T>(y - y_) * b_[k];
      } else {
        // A vector over columns meets one row, or two.
        const V first = hn::Set(d, static_cast<T>(y) + T{0.5});
        for (int at = 0; at < kRowShares; at += kReals<T>) {
          const float* const rows = kRowShares == 64 ? kRows : kColumns;
          const V centre = hn::Add(first, LoadReals<T>(rows + at));
          const V b = hn::Set(d, b_[k]);
          hn::Store(kForm == Form::kDirect ? hn::Mul(hn::Sub(centre, hn::Set(d, e_[k])), b)
                                           : hn::Add(hn::Mul(b, centre), hn::Set(d, e_[k])),
                    d, offsets_[k] + at);
        }
        row_[k] = offsets_[k][0];
      }
    }
  }

  HWY_INLINE void Classify(int i, std::uint32_t& any, std::uint32_t& full) const {
    const RealTag<T> d;
    V t[3];
    const V x = hn::Mul(RealsFrom<T>(static_cast<T>(i)), hn::Set(d, T{8}));
    for (int k = 0; k < 3; ++k) t[k] = hn::Add(hn::Set(d, row_[k]), ColumnShare(k, x));
    any = static_cast<std::uint32_t>(MaskBits(d, AllReach(t, reject_)));
    full = static_cast<std::uint32_t>(MaskBits(d, AllReach(t, accept_)));
  }

  HWY_INLINE std::uint64_t Pixels(int i) const {
    const RealTag<T> d;
    constexpr int kParts = kReals<T> < 8 ? 8 / kReals<T> : 1;
    V t[3][kParts];
    for (int k = 0; k < 3; ++k) {
      for (int part = 0; part < kParts; ++part) {
        if constexpr (kForm == Form::kStepped) {
          t[k][part] = hn::Set(d, row_[k] + static_cast<T>(8 * i) * a_[k]);
        } else {
          const V columns = LoadReals<T>(kColumns + part * kReals<T>);
          t[k][part] = ColumnShare(k, hn::Add(columns, hn::Set(d, static_cast<T>(8 * i))));
        }
      }
    }
    std::uint64_t bits = 0;
    for (int at = 0; at < 64; at += kReals<T>) {
      V e[3];
      for (int k = 0; k < 3; ++k) {
        const V share = kForm == Form::kStepped || kRowShares == 64
                            ? hn::Load(d, offsets_[k] + at)
                            : hn::Set(d, offsets_[k][at / 8]);
        e[k] = hn::Add(t[k][at / kReals<T> % kParts], share);
      }
      bits |= MaskBits(d, AllReach(e, least_)) << at;
    }
    return bits;
  }

 private:
  using V = RealVec<T>;
  static constexpr int kRowShares = kReals<T> > 8 ? 64 : 8;

  /// Of columns x beyond the first tile's.
  HWY_INLINE V ColumnShare(int k, V x) const {
    const RealTag<T> d;
    const V a = hn::Set(d, a_[k]);
    if constexpr (kForm == Form::kStepped) return hn::Mul(x, a);
    const V centre = hn::Add(x, hn::Set(d, static_cast<T>(x_) + T{0.5}));
    if constexpr (kForm == Form::kDirect) return hn::Mul(hn::Sub(centre, hn::Set(d, vx_[k])), a);
    return hn::Mul(a, centre);
  }
  HWY_INLINE static hn::Mask<RealTag<T> > AllReach(const V (&v)[3], const T (&least)[3]) {
    const RealTag<T> d;
    return hn::And(hn::And(hn::Ge(v[0], hn::Set(d, least[0])), hn::Ge(v[1], hn::Set(d, least[1]))),
                   hn::Ge(v[2], hn::Set(d, least[2])));
  }

  alignas(64) T offsets_[3][64];  ///< stepped: of a tile's pixels; else shares of a tile's rows
  int x_, y_;
  T e_[3];  ///< stepped: at the first tile; affine: C; direct: vy
  T vx_[3];
  T a_[3], b_[3], least_[3], reject_[3], accept_[3];
  T row_[3];
};

template <class T, Form kForm, class Sink>
HWY_NOINLINE void DrawTilesOf(const EdgeBlock<T>& block, int i, Sink sink) {
  RealTileEdges<T, kForm> edges(block, i);
  WalkTiles(edges, block.BoxOf(i), sink);
}

template <class T, Form kForm, class Sink>
void DrawTiles(const KernelView& view) {
  Sink sink(view);
  EdgeBlock<T> block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpEdges<T, kForm, Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallMasks<T, kForm, false>(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          const std::uint64_t bits = block.masks[i] & SmallBoxMask(block, i);
          if (bits != 0) sink.Mask8x8(block.x0[i], block.y0[i], bits);
        } else {
          DrawTilesOf<T, kForm>(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_TILES_H_
