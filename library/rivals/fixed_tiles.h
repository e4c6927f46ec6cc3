// Traversal::kTiles in integers: vertices snapped to 1/256 px.
//
// With X, Y in units of 1/256 px, E = (X - VX) A + (Y - VY) B is an integer, and one pixel further
// it grows by 256 A. An edge that does not own its ties subtracts 1; then E >= 0 exactly where
// floor(E / 256) >= 0, and floor(E / 256) grows by A a pixel: that is what kInt32 steps. kInt64
// steps E itself.
//
// Range: |coordinates| <= 2^22 (kFixedRange px), so |A|, |B| <= 2^23 and |E| < 2 * 2^25 * 2^23
// = 2^49 at a pixel of a target of 65536 px: exact in double. |floor(E / 256)| <= 2^41.
// Proof: reference/proofs/fixed_tiles.g, which has the integers of a tile, too.
#ifndef RASTERPROOF_LIBRARY_RIVALS_FIXED_TILES_H_
#define RASTERPROOF_LIBRARY_RIVALS_FIXED_TILES_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/edges.h"
#include "library/rivals/reals.h"
#include "library/rivals/tile_walk.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// kFixedRange of rival.h.
constexpr float kFixedLimit = 16384;

struct alignas(64) FixedBlock : Block {
  std::int32_t a[3][kBlock], b[3][kBlock];
  double e[3][kBlock];          ///< at the box's first pixel: floor(E / 256), or E in 64 bits
  std::uint32_t narrow;         ///< triangles whose values in the tiles of their box fit in 30 bits
  std::uint64_t masks[kBlock];  ///< of small ones: coverage of the 8x8 pixels from the box's corner
};

/// The first pixel whose centre is at or beyond v / 256: ceil((v - 128) / 256), in [0, size].
template <class D>
HWY_INLINE hn::Vec<D> FirstCentreFromFixed(D d, hn::Vec<D> v, int size) {
  const auto from = hn::ShiftRight<8>(hn::Add(v, hn::Set(d, 127)));
  return hn::Min(hn::Max(from, hn::Zero(d)), hn::Set(d, size));
}

/// Corners snapped to 1/256 px, nearest-even; 0 in lanes that are not in range, or NaN.
struct SnappedCorners {
  hn::Vec<DDI> x[3], y[3];

  HWY_INLINE explicit SnappedCorners(const Corners<hn::Vec<DDF>>& c) {
    const DDF d;
    const auto limit = hn::Set(d, kFixedLimit);
    auto in_range = hn::Le(hn::Abs(c.x[0]), limit);
    for (int k = 0; k < 3; ++k) {
      in_range = hn::And(in_range,
                         hn::And(hn::Le(hn::Abs(c.x[k]), limit), hn::Le(hn::Abs(c.y[k]), limit)));
    }
    const auto scale = hn::Set(d, 256.0F);
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::NearestInt(hn::IfThenElseZero(in_range, hn::Mul(c.x[k], scale)));
      y[k] = hn::NearestInt(hn::IfThenElseZero(in_range, hn::Mul(c.y[k], scale)));
    }
  }

  /// Swaps the last two corners in the other lanes.
  HWY_INLINE void SwapUnless(hn::Mask<DDI> is_front) {
    for (auto* const v : {x, y}) {
      const auto one = hn::IfThenElse(is_front, v[1], v[2]);
      v[2] = hn::IfThenElse(is_front, v[2], v[1]);
      v[1] = one;
    }
  }
};

template <bool kIn32, bool kWithZ>
HWY_NOINLINE void SetUpFixed(const KernelView& view, const std::uint32_t* indices,
                             FixedBlock& block) {
  const DDF d;
  const DDI di;
  const DD dd;
  block.narrow = 0;
  for (int at = 0; at < kBlock; at += kDoubles) {
    const auto c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    SnappedCorners snapped(c);
    auto& x = snapped.x;
    auto& y = snapped.y;
    const auto one = hn::Set(di, 1);
    const auto x0 = FirstCentreFromFixed(di, Min3(x), view.width);
    const auto x1 = FirstCentreFromFixed(di, hn::Add(Max3(x), one), view.width);
    const auto y0 = FirstCentreFromFixed(di, Min3(y), view.height);
    const auto y1 = FirstCentreFromFixed(di, hn::Add(Max3(y), one), view.height);
    const std::uint32_t boxed = StoreBox(di, x0, x1, y0, y1, at, block);
    const VD area = hn::Sub(
        hn::Mul(hn::PromoteTo(dd, hn::Sub(x[2], x[0])), hn::PromoteTo(dd, hn::Sub(y[1], y[0]))),
        hn::Mul(hn::PromoteTo(dd, hn::Sub(y[2], y[0])), hn::PromoteTo(dd, hn::Sub(x[1], x[0]))));
    const std::uint32_t front =
        static_cast<std::uint32_t>(MaskBits(dd, hn::Gt(area, hn::Zero(dd))));
    const std::uint32_t back = static_cast<std::uint32_t>(MaskBits(dd, hn::Lt(area, hn::Zero(dd))));
    snapped.SwapUnless(MaskOf(di, front));
    const auto centre = hn::Set(di, 128);
    const auto px = hn::Add(hn::ShiftLeft<8>(x0), centre);
    const auto py = hn::Add(hn::ShiftLeft<8>(y0), centre);
    // A group of tiles that begins in the box may reach 128 px beyond it.
    const VD width = hn::PromoteTo(dd, hn::Add(hn::Sub(x1, x0), hn::Set(di, 8 * kBlock + 8)));
    const VD height = hn::PromoteTo(dd, hn::Add(hn::Sub(y1, y0), hn::Set(di, 16)));
    VD most = hn::Zero(dd);
    for (int k = 0; k < 3; ++k) {
      const int next = k == 2 ? 0 : k + 1;
      const auto a = hn::Sub(y[next], y[k]);
      const auto b = hn::Sub(x[k], x[next]);
      // -1 where the edge owns no ties: not (a > 0 or (a == 0 and b > 0)).
      const auto owns = hn::Or(hn::Gt(a, hn::Zero(di)),
                               hn::And(hn::Eq(a, hn::Zero(di)), hn::Gt(b, hn::Zero(di))));
      const auto bias = hn::IfThenElse(owns, hn::Zero(di), hn::Set(di, -1));
      const VD ad = hn::PromoteTo(dd, a);
      const VD bd = hn::PromoteTo(dd, b);
      const VD at_pixel = hn::Add(hn::Mul(hn::PromoteTo(dd, hn::Sub(px, x[k])), ad),
                                  hn::Mul(hn::PromoteTo(dd, hn::Sub(py, y[k])), bd));
      const VD biased = hn::Add(at_pixel, hn::PromoteTo(dd, bias));
      const VD e = kIn32 ? hn::Floor(hn::Mul(biased, hn::Set(dd, 1.0 / 256))) : biased;
      hn::Store(a, di, block.a[k] + at);
      hn::Store(b, di, block.b[k] + at);
      hn::Store(e, dd, block.e[k] + at);
      most = hn::Max(most, hn::Add(hn::Abs(e), hn::Add(hn::Mul(hn::Abs(ad), width),
                                                       hn::Mul(hn::Abs(bd), height))));
    }
    const auto narrow = hn::Lt(most, hn::Set(dd, 0x1p30));
    block.narrow |= static_cast<std::uint32_t>(MaskBits(dd, narrow)) << at;
    block.front |= front << at;
    block.drawn |= ((front | back) & boxed) << at;
  }
  FindSmall(block);
  // A small box is what the target leaves of a triangle: its values may be large.
  if constexpr (kIn32) block.small &= block.narrow;
}

/// E and its steps by pixel of triangles `at` on, in 32 or 64 bits.
template <bool kIn32>
struct FixedLanes {
  using D = DI;
  VI e[3], a[3], b[3];

  HWY_INLINE FixedLanes(const FixedBlock& block, int at) {
    for (int k = 0; k < 3; ++k) {
      alignas(64) std::int32_t values[kLanes];
      for (int i = 0; i < kLanes; i += kDoubles) {
        const VD v = hn::Load(DD(), block.e[k] + at + i);
        hn::Store(hn::DemoteTo(DDI(), v), DDI(), values + i);
      }
      e[k] = hn::Load(D(), values);
      a[k] = hn::Load(D(), block.a[k] + at);
      b[k] = hn::Load(D(), block.b[k] + at);
    }
  }
};
template <>
struct FixedLanes<false> {
  using D = DI64;
  VI64 e[3], a[3], b[3];

  HWY_INLINE FixedLanes(const FixedBlock& block, int at) {
    for (int k = 0; k < 3; ++k) {
      e[k] = ToInt64(hn::Load(DD(), block.e[k] + at));
      a[k] = hn::ShiftLeft<8>(hn::PromoteTo(D(), hn::Load(DDI(), block.a[k] + at)));
      b[k] = hn::ShiftLeft<8>(hn::PromoteTo(D(), hn::Load(DDI(), block.b[k] + at)));
    }
  }
};

/// Fills in the masks of the small triangles, as FindSmallMasks of edges.h. Inside is where no
/// value has its sign bit.
template <bool kIn32>
HWY_NOINLINE void FindSmallFixedMasks(FixedBlock& block) {
  using D = typename FixedLanes<kIn32>::D;
  constexpr int kN = kLanesOf<D>;
  for (int at = 0; at < kBlock; at += kN) {
    if (((block.small >> at) & ((std::uint64_t{1} << kN) - 1)) == 0) continue;
    FixedLanes<kIn32> lanes(block, at);
    LaneMasks<D> masks;
    for (int r = 0; r < block.height; ++r) {
      hn::Vec<D> e[3];
      for (int k = 0; k < 3; ++k) {
        e[k] = lanes.e[k];
        lanes.e[k] = hn::Add(lanes.e[k], lanes.b[k]);
      }
      for (int c = 0; c < block.width; ++c) {
        masks.AddUnless(r, c, hn::Or(hn::Or(e[0], e[1]), e[2]));
        for (int k = 0; k < 3; ++k) e[k] = hn::Add(e[k], lanes.a[k]);
      }
    }
    masks.Store(block.masks + at);
  }
}

template <bool kNarrow>
struct FixedTileTag {
  using type = DI;
};
template <>
struct FixedTileTag<false> {
  using type = DD;
};

/// The edges of one triangle, for WalkTiles: tiles in 32 bits where they fit, else in doubles;
/// pixels of a tile that is neither accepted nor rejected in 32 bits.
template <bool kNarrow>
class FixedTileEdges {
 public:
  using D = typename FixedTileTag<kNarrow>::type;
  using T = hn::TFromD<D>;
  static constexpr int kTiles = kLanesOf<D>;

  HWY_INLINE FixedTileEdges(const FixedBlock& block, int i) {
    const DI di;
    y_ = block.y0[i] & ~7;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = block.a[k][i];
      const std::int32_t b = block.b[k][i];
      a_[k] = static_cast<T>(a);
      b_[k] = static_cast<T>(b);
      e_[k] = static_cast<T>(block.e[k][i]) - static_cast<T>(block.x0[i] & 7) * a_[k] -
              static_cast<T>(block.y0[i] & 7) * b_[k];
      beyond_reject_[k] = static_cast<T>(-7 * (Greatest(a, 0) + Greatest(b, 0)) - 1);
      beyond_accept_[k] = static_cast<T>(-7 * (Least(a, 0) + Least(b, 0)) - 1);
      for (int tile = 0; tile < kTiles; ++tile) tiles_[k][tile] = static_cast<T>(8 * tile) * a_[k];
      const VI rows = hn::Set(di, b);
      const VI columns = hn::Set(di, a);
      for (int at = 0; at < 64; at += kLanes) {
        const VI c = hn::Load(di, kIntColumns + at);
        const VI r = hn::Load(di, kIntRows + at);
        hn::Store(hn::Add(hn::Mul(c, columns), hn::Mul(r, rows)), di, offsets_[k] + at);
      }
    }
  }

  HWY_INLINE void BeginRow(int y) {
    for (int k = 0; k < 3; ++k) row_[k] = e_[k] + static_cast<T>(y - y_) * b_[k];
  }

  HWY_INLINE void Classify(int i, std::uint32_t& any, std::uint32_t& full) const {
    const D d;
    hn::Vec<D> t[3];
    for (int k = 0; k < 3; ++k) {
      const T first = row_[k] + static_cast<T>(8 * i) * a_[k];
      t[k] = hn::Add(hn::Set(d, first), hn::Load(d, tiles_[k]));
    }
    any = AllBeyond(t, beyond_reject_);
    full = AllBeyond(t, beyond_accept_);
  }

  HWY_INLINE std::uint64_t Pixels(int i) const {
    const DI di;
    VI t[3];
    for (int k = 0; k < 3; ++k) {
      t[k] = hn::Set(di, Clamped(row_[k] + static_cast<T>(8 * i) * a_[k]));
    }
    std::uint64_t bits = 0;
    for (int at = 0; at < 64; at += kLanes) {
      VI e[3];
      for (int k = 0; k < 3; ++k) e[k] = hn::Add(t[k], hn::Load(di, offsets_[k] + at));
      const VI all = hn::Or(hn::Or(e[0], e[1]), e[2]);
      bits |= MaskBits(di, hn::Gt(all, hn::Set(di, -1))) << at;
    }
    return bits;
  }

 private:
  HWY_INLINE static std::uint32_t AllBeyond(const hn::Vec<D> (&v)[3], const T (&limit)[3]) {
    const D d;
    const auto beyond =
        hn::And(hn::And(hn::Gt(v[0], hn::Set(d, limit[0])), hn::Gt(v[1], hn::Set(d, limit[1]))),
                hn::Gt(v[2], hn::Set(d, limit[2])));
    return static_cast<std::uint32_t>(MaskBits(d, beyond));
  }
  /// Within a tile a value changes by at most 14 * 2^23 < 2^27: beyond 2^30 its sign is settled.
  HWY_INLINE static std::int32_t Clamped(T value) {
    if constexpr (kNarrow) {
      return value;
    } else {
      return static_cast<std::int32_t>(Greatest(-0x1p30, Least(0x1p30, value)));
    }
  }

  alignas(64) std::int32_t offsets_[3][64];
  alignas(64) T tiles_[3][kTiles];
  int y_;
  T e_[3], a_[3], b_[3], beyond_reject_[3], beyond_accept_[3], row_[3];
};

/// The same in 64 bits throughout: E, of which a pixel is 256 A.
class WideTileEdges {
 public:
  static constexpr int kTiles = kDoubles;

  HWY_INLINE WideTileEdges(const FixedBlock& block, int i) {
    y_ = block.y0[i] & ~7;
    for (int k = 0; k < 3; ++k) {
      a_[k] = 256 * std::int64_t{block.a[k][i]};
      b_[k] = 256 * std::int64_t{block.b[k][i]};
      e_[k] = static_cast<std::int64_t>(block.e[k][i]) - (block.x0[i] & 7) * a_[k] -
              (block.y0[i] & 7) * b_[k];
      reject_[k] = 7 * (Greatest(a_[k], std::int64_t{0}) + Greatest(b_[k], std::int64_t{0}));
      accept_[k] = 7 * (Least(a_[k], std::int64_t{0}) + Least(b_[k], std::int64_t{0}));
      for (int c = 0; c < 8; ++c) columns_[k][c] = c * a_[k];
      for (int tile = 0; tile < kTiles; ++tile) tiles_[k][tile] = 8 * tile * a_[k];
    }
  }

  HWY_INLINE void BeginRow(int y) {
    for (int k = 0; k < 3; ++k) row_[k] = e_[k] + (y - y_) * b_[k];
  }

  HWY_INLINE void Classify(int i, std::uint32_t& any, std::uint32_t& full) const {
    const DI64 d;
    VI64 most = hn::Zero(d);  // negative where an edge rejects the tile
    VI64 least = hn::Zero(d);
    for (int k = 0; k < 3; ++k) {
      const VI64 t = hn::Add(hn::Set(d, row_[k] + 8 * i * a_[k]), hn::Load(d, tiles_[k]));
      most = hn::Or(most, hn::Add(t, hn::Set(d, reject_[k])));
      least = hn::Or(least, hn::Add(t, hn::Set(d, accept_[k])));
    }
    constexpr std::uint32_t kAll = (1U << kTiles) - 1;
    any = static_cast<std::uint32_t>(NegativeLanes(most)) ^ kAll;
    full = static_cast<std::uint32_t>(NegativeLanes(least)) ^ kAll;
  }

  HWY_INLINE std::uint64_t Pixels(int i) const {
    const DI64 d;
    VI64 columns[3][8 / kDoubles];
    for (int k = 0; k < 3; ++k) {
      const VI64 t = hn::Set(d, row_[k] + 8 * i * a_[k]);
      for (int c = 0; c < 8; c += kDoubles) {
        columns[k][c / kDoubles] = hn::Add(t, hn::Load(d, columns_[k] + c));
      }
    }
    std::uint64_t outside = 0;
    for (int r = 0; r < 8; ++r) {
      for (int c = 0; c < 8; c += kDoubles) {
        VI64 all = hn::Zero(d);
        for (int k = 0; k < 3; ++k) all = hn::Or(all, columns[k][c / kDoubles]);
        outside |= NegativeLanes(all) << (8 * r + c);
      }
      for (int k = 0; k < 3; ++k) {
        for (VI64& column : columns[k]) column = hn::Add(column, hn::Set(d, b_[k]));
      }
    }
    return ~outside;
  }

 private:
  alignas(64) std::int64_t columns_[3][8], tiles_[3][kTiles];
  int y_;
  std::int64_t e_[3], a_[3], b_[3], reject_[3], accept_[3], row_[3];
};

template <class Edges, class Sink>
HWY_NOINLINE void DrawFixedTilesOf(const FixedBlock& block, int i, Sink sink) {
  Edges edges(block, i);
  WalkTiles(edges, block.BoxOf(i), sink);
}

/// kIn32: Arithmetic::kInt32, otherwise kInt64.
template <bool kIn32, class Sink>
void DrawFixedTiles(const KernelView& view) {
  Sink sink(view);
  FixedBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpFixed<kIn32, Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallFixedMasks<kIn32>(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          const std::uint64_t bits = block.masks[i] & SmallBoxMask(block, i);
          if (bits != 0) sink.Mask8x8(block.x0[i], block.y0[i], bits);
        } else if constexpr (!kIn32) {
          DrawFixedTilesOf<WideTileEdges>(block, i, sink);
        } else if (((block.narrow >> i) & 1) != 0) {
          DrawFixedTilesOf<FixedTileEdges<true>>(block, i, sink);
        } else {
          DrawFixedTilesOf<FixedTileEdges<false>>(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_FIXED_TILES_H_
