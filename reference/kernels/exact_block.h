// Setting up a block of triangles for the exact kernel: corners sorted by y, boxes, slopes.
#ifndef RASTERPROOF_REFERENCE_KERNELS_EXACT_BLOCK_H_
#define RASTERPROOF_REFERENCE_KERNELS_EXACT_BLOCK_H_

#include <cstddef>
#include <cstdint>

#include "reference/kernels/blocks.h"
#include "reference/kernels/exact_crossings.h"
#include "reference/kernels/kernel_table.h"
#include "reference/kernels/vectors.h"

namespace rasterproof::reference::kernels::HWY_NAMESPACE {

/// Edges of a triangle whose corners are sorted by y: upper short, lower short, long.
constexpr int kUpperEdge = 0;
constexpr int kLowerEdge = 1;
constexpr int kLongEdge = 2;
constexpr int kStartOf[3] = {0, 1, 0};
constexpr int kEndOf[3] = {1, 2, 2};

struct alignas(64) ExactBlock : Block {
  float x[3][kBlock], y[3][kBlock];  ///< corners, least y first
  // Of near triangles, whose box is at most kNearSide a side: relative to its first pixel.
  float sx[3][kBlock], sy[3][kBlock], slope[3][kBlock];
  std::uint64_t masks[kBlock];
  double long_slope[3][kBlock];     ///< of the others
  std::int32_t middle_row[kBlock];  ///< of the others: the first row at or below the middle corner
  std::uint32_t inside;             ///< wholly on the target
  std::uint32_t near;               ///< small ones, too
  std::uint32_t odd;                ///< sorting swapped two of them an odd number of times
  std::uint32_t far;                ///< beyond kGuessDomain
  std::uint32_t long_is_left;       ///< of small ones that cover anything

  ExactEdge EdgeOf(int edge, int i) const {
    const int a = kStartOf[edge];
    const int c = kEndOf[edge];
    return {x[a][i], y[a][i], x[c][i], y[c][i], 0, 0};
  }
};

/// Facing by where the long edge lies: v0 above v1 above v2, v1 to the right, turns clockwise on
/// screen.
HWY_INLINE bool IsFrontBy(bool long_is_left, bool odd) { return long_is_left == odd; }

template <class V, class M>
HWY_INLINE void SwapWhere(M where, V& a, V& b) {
  const V first = hn::IfThenElse(where, b, a);
  b = hn::IfThenElse(where, a, b);
  a = first;
}

/// Sorts corners by y. Returns the lanes in which two were swapped an odd number of times.
HWY_INLINE std::uint64_t SortByY(Corners<VF>& c) {
  const DF d;
  std::uint64_t odd = 0;
  for (const int k : {0, 1, 0}) {
    const auto swap = hn::Gt(c.y[k], c.y[k + 1]);
    SwapWhere(swap, c.x[k], c.x[k + 1]);
    SwapWhere(swap, c.y[k], c.y[k + 1]);
    odd ^= MaskBits(d, swap);
  }
  return odd;
}

/// Lanes whose corners are all finite.
HWY_INLINE hn::Mask<DF> AreFinite(const Corners<VF>& c) {
  // 0 of a finite number, NaN of others.
  VF sum = hn::Sub(c.x[0], c.x[0]);
  for (const VF v : {c.y[0], c.x[1], c.y[1], c.x[2], c.y[2]}) sum = hn::Add(sum, hn::Sub(v, v));
  return hn::Eq(sum, hn::Zero(DF()));
}

/// Lanes that lie wholly on the target: sorted corners, their least and greatest x.
HWY_INLINE hn::Mask<DF> AreInside(const KernelView& view, const Corners<VF>& c, VF least_x,
                                  VF most_x) {
  const DF d;
  const VF zero = hn::Zero(d);
  const VF top = hn::Set(d, static_cast<float>(view.first_row));
  const auto starts = hn::And(hn::Ge(least_x, zero), hn::Ge(c.y[0], top));
  const auto ends = hn::And(hn::Le(most_x, hn::Set(d, static_cast<float>(view.width))),
                            hn::Le(c.y[2], hn::Set(d, static_cast<float>(view.height))));
  return hn::And(starts, ends);
}

/// Corners relative to the first pixel of the box, and slopes. The differences are exact for
/// triangles on the target: no corner lies more than half a pixel before that pixel, and none of
/// those is nearer to 0 than that.
HWY_INLINE void StoreNear(const Corners<VF>& c, VF left, VF top, int at, ExactBlock& block) {
  const DF d;
  VF x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = hn::Sub(c.x[k], left);
    y[k] = hn::Sub(c.y[k], top);
    hn::Store(x[k], d, block.sx[k] + at);
    hn::Store(y[k], d, block.sy[k] + at);
  }
  for (int e = 0; e < 3; ++e) {
    const int a = kStartOf[e];
    const int b = kEndOf[e];
    hn::Store(hn::Div(hn::Sub(x[b], x[a]), hn::Sub(y[b], y[a])), d, block.slope[e] + at);
  }
}

template <bool kWithZ>
HWY_INLINE void SetUpExact(const KernelView& view, const std::uint32_t* indices,
                           ExactBlock& block) {
  const DF d;
  const DI di;
  block.small = 0;
  block.near = 0;
  block.inside = 0;
  block.odd = 0;
  block.far = 0;
  block.width = 8;
  VI rows = hn::Zero(di);
  const VI first_row = hn::Set(di, view.first_row);
  for (int at = 0; at < kBlock; at += kLanes) {
    Corners<VF> c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    const auto is_finite = AreFinite(c);
    block.odd |= static_cast<std::uint32_t>(SortByY(c)) << at;
    const VF least_x = Min3(c.x);
    const VF most_x = Max3(c.x);
    const VI x0 = FirstCentreFrom(d, least_x, view.width);
    const VI x1 = FirstCentreFrom(d, most_x, view.width);
    const VI y0 = hn::Max(first_row, FirstCentreFrom(d, c.y[0], view.height));
    const VI y1 = FirstCentreFrom(d, c.y[2], view.height);
    const std::uint32_t boxed = StoreBox(di, x0, x1, y0, y1, at, block);
    for (int k = 0; k < 3; ++k) {
      hn::Store(c.x[k], d, block.x[k] + at);
      hn::Store(c.y[k], d, block.y[k] + at);
    }
    hn::Store(FirstCentreFrom(d, c.y[1], view.height), di, block.middle_row + at);
    const VI side = hn::Max(hn::Sub(x1, x0), hn::Sub(y1, y0));
    const auto is_narrow = hn::Lt(side, hn::Set(di, kNearSide + 1));
    const auto fits = hn::Lt(side, hn::Set(di, 9));
    const VF farthest = hn::Max(hn::Abs(least_x), hn::Abs(most_x));
    const auto is_far = hn::Gt(farthest, hn::Set(d, kGuessDomain));
    const std::uint32_t drawn = boxed & static_cast<std::uint32_t>(MaskBits(d, is_finite));
    const std::uint32_t inside =
        drawn & static_cast<std::uint32_t>(MaskBits(d, AreInside(view, c, least_x, most_x)));
    const std::uint32_t near = inside & static_cast<std::uint32_t>(MaskBits(di, is_narrow));
    const std::uint32_t small = near & static_cast<std::uint32_t>(MaskBits(di, fits));
    block.drawn |= drawn << at;
    block.inside |= inside << at;
    block.near |= near << at;
    block.small |= small << at;
    block.far |= static_cast<std::uint32_t>(MaskBits(d, is_far)) << at;
    if (near == 0) continue;
    rows = hn::Max(rows, hn::IfThenElseZero(MaskOf(di, small), hn::Sub(y1, y0)));
    StoreNear(c, hn::ConvertTo(d, x0), hn::ConvertTo(d, y0), at, block);
  }
  block.height = hn::GetLane(hn::MaxOfLanes(di, rows));
}

/// The slopes of triangles that are not near.
HWY_INLINE void SetUpSlopes(ExactBlock& block) {
  const DD dd;
  const DDF df;
  for (int at = 0; at < kBlock; at += kDoubles) {
    VD x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::PromoteTo(dd, hn::Load(df, block.x[k] + at));
      y[k] = hn::PromoteTo(dd, hn::Load(df, block.y[k] + at));
    }
    for (int e = 0; e < 3; ++e) {
      const int a = kStartOf[e];
      const int b = kEndOf[e];
      hn::Store(hn::Div(hn::Sub(x[b], x[a]), hn::Sub(y[b], y[a])), dd, block.long_slope[e] + at);
    }
  }
}

}  // namespace rasterproof::reference::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_REFERENCE_KERNELS_EXACT_BLOCK_H_
