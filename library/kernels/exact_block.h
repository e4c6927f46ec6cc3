// Setting up a block of triangles for the exact kernel: corners sorted by y, boxes, slopes.
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_BLOCK_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_BLOCK_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Edges of a triangle whose corners are sorted by y: upper short, lower short, long.
constexpr int kUpperEdge = 0;
constexpr int kLowerEdge = 1;
constexpr int kLongEdge = 2;
constexpr int kStartOf[3] = {0, 1, 0};
constexpr int kEndOf[3] = {1, 2, 2};

/// Of near triangles, whose box is at most kNearSide a side, and of small ones that have ties:
/// corners relative to its first pixel, least y first.
struct alignas(64) NearBlock {
  float sx[3][kBlock], sy[3][kBlock], slope[3][kBlock];
  std::uint32_t odd;  ///< sorting swapped two of them an odd number of times
};

struct alignas(64) ExactBlock : Block, NearBlock {
  float x[3][kBlock], y[3][kBlock];  ///< corners, least y first
  std::uint64_t masks[kBlock];
  double long_slope[3][kBlock];     ///< of the others
  std::int32_t middle_row[kBlock];  ///< of the others: the first row at or below the middle corner
  std::uint32_t inside;             ///< wholly on the target
  std::uint32_t near;
  std::uint32_t far;           ///< beyond kGuessDomain
  std::uint32_t stepped;       ///< no x beyond kSteppedSide
  std::uint32_t long_is_left;  ///< of small ones that cover anything

  ExactEdge EdgeOf(int edge, int i) const {
    const int a = kStartOf[edge];
    const int c = kEndOf[edge];
    return {x[a][i], y[a][i], x[c][i], y[c][i], 0, 0};
  }
};

/// Facing by where the long edge lies: v0 above v1 above v2, v1 to the right, turns clockwise on
/// screen.
HWY_INLINE bool IsFrontBy(bool long_is_left, bool odd) { return long_is_left == odd; }

/// By what differs: a choice takes more instructions.
HWY_INLINE void SwapWhere(hn::Mask<DF> where, VF& a, VF& b) {
  const VF differs = hn::IfThenElseZero(where, hn::Xor(a, b));
  a = hn::Xor(a, differs);
  b = hn::Xor(b, differs);
}

/// Sorts corners by y. Returns the lanes in which two were swapped an odd number of times.
///
/// Domain:     any; of NaN any order, and any value of y.
HWY_INLINE std::uint64_t SortByY(Corners<VF>& c) {
  const DF d;
  std::uint64_t odd = 0;
  for (const int k : {0, 1, 0}) {
    const auto swap = hn::Gt(c.y[k], c.y[k + 1]);
    SwapWhere(swap, c.x[k], c.x[k + 1]);
    const VF first = hn::Min(c.y[k], c.y[k + 1]);
    c.y[k + 1] = hn::Max(c.y[k], c.y[k + 1]);
    c.y[k] = first;
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

/// Corners relative to the first pixel of the box. The differences are exact for triangles on the
/// target: no corner lies more than half a pixel before that pixel, and none of those is nearer to
/// 0 than that.
HWY_INLINE void StoreRelative(const Corners<VF>& c, VF left, VF top, int at, ExactBlock& block) {
  const DF d;
  for (int k = 0; k < 3; ++k) {
    hn::Store(hn::Sub(c.x[k], left), d, block.sx[k] + at);
    hn::Store(hn::Sub(c.y[k], top), d, block.sy[k] + at);
  }
}

/// The slopes of near triangles.
HWY_INLINE void StoreNearSlopes(int at, ExactBlock& block) {
  const DF d;
  const auto difference = [&](const float(*p)[kBlock], int e) {
    return hn::Sub(hn::Load(d, p[kEndOf[e]] + at), hn::Load(d, p[kStartOf[e]] + at));
  };
  for (int e = 0; e < 3; ++e) {
    hn::Store(hn::Div(difference(block.sx, e), difference(block.sy, e)), d, block.slope[e] + at);
  }
}

/// The slopes of triangles that are not near.
HWY_INLINE void StoreFarSlopes(int at, ExactBlock& block) {
  const DD dd;
  const DDF df;
  for (int i = at; i < at + kLanes; i += kDoubles) {
    VD x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::PromoteTo(dd, hn::Load(df, block.x[k] + i));
      y[k] = hn::PromoteTo(dd, hn::Load(df, block.y[k] + i));
    }
    for (int e = 0; e < 3; ++e) {
      const int a = kStartOf[e];
      const int b = kEndOf[e];
      hn::Store(hn::Div(hn::Sub(x[b], x[a]), hn::Sub(y[b], y[a])), dd, block.long_slope[e] + i);
    }
  }
}

/// Triangles of one group of lanes: corners sorted by y, and the box, not cut to the target.
struct ExactGroup {
  Corners<VF> c;
  VF least_x, most_x;
  VF x0, x1, y0, y1;
  std::uint32_t small;   ///< drawn, on the target, box at most 8x8
  std::uint32_t others;  ///< that may be drawn

  HWY_INLINE ExactGroup(const KernelView& view, const Corners<VF>& corners, std::uint32_t& odd) {
    const DF d;
    // One by one: copied whole they pass through memory.
    for (int k = 0; k < 3; ++k) {
      c.x[k] = corners.x[k];
      c.y[k] = corners.y[k];
    }
    odd = static_cast<std::uint32_t>(SortByY(c));
    least_x = Min3(c.x);
    most_x = Max3(c.x);
    const VF half = hn::Set(d, 0.5F);
    x0 = hn::Ceil(hn::Sub(least_x, half));
    x1 = hn::Ceil(hn::Sub(most_x, half));
    y0 = hn::Ceil(hn::Sub(c.y[0], half));
    y1 = hn::Ceil(hn::Sub(c.y[2], half));
    const VF width = hn::Sub(x1, x0);
    const VF height = hn::Sub(y1, y0);
    const auto is_full = hn::Gt(hn::Min(width, height), hn::Zero(d));
    const auto fits = hn::Lt(hn::Max(width, height), hn::Set(d, 9.0F));
    // Of corners on the target it is NaN if and only if one is, which sorting loses.
    const VF sum =
        hn::Add(hn::Add(hn::Add(corners.x[0], corners.x[1]), hn::Add(corners.x[2], corners.y[0])),
                hn::Add(corners.y[1], corners.y[2]));
    const auto is_small = hn::And(hn::And(is_full, fits),
                                  hn::And(AreInside(view, c, least_x, most_x), hn::Eq(sum, sum)));
    small = static_cast<std::uint32_t>(MaskBits(d, is_small));
    others = static_cast<std::uint32_t>(MaskBits(d, is_full)) & ~small;
  }
};

/// Sets up the triangles of a group that are not small.
HWY_INLINE void SetUpOthers(const KernelView& view, const Corners<VF>& corners, const ExactGroup& g,
                            int at, ExactBlock& block) {
  const DF d;
  const DI di;
  const Corners<VF>& c = g.c;
  const VI x0 = FirstCentreFrom(d, g.least_x, view.width);
  const VI x1 = FirstCentreFrom(d, g.most_x, view.width);
  const VI y0 = hn::Max(hn::Set(di, view.first_row), FirstCentreFrom(d, c.y[0], view.height));
  const VI y1 = FirstCentreFrom(d, c.y[2], view.height);
  const std::uint32_t boxed = g.others & StoreBox(di, x0, x1, y0, y1, at, block);
  for (int k = 0; k < 3; ++k) {
    hn::Store(c.x[k], d, block.x[k] + at);
    hn::Store(c.y[k], d, block.y[k] + at);
  }
  hn::Store(FirstCentreFrom(d, c.y[1], view.height), di, block.middle_row + at);
  const VI side = hn::Max(hn::Sub(x1, x0), hn::Sub(y1, y0));
  const auto is_narrow = hn::Lt(side, hn::Set(di, kNearSide + 1));
  const VF farthest = hn::Max(hn::Abs(g.least_x), hn::Abs(g.most_x));
  const auto is_far = hn::Gt(farthest, hn::Set(d, kGuessDomain));
  const std::uint32_t drawn = boxed & static_cast<std::uint32_t>(MaskBits(d, AreFinite(corners)));
  const std::uint32_t inside =
      drawn & static_cast<std::uint32_t>(MaskBits(d, AreInside(view, c, g.least_x, g.most_x)));
  const std::uint32_t near = inside & static_cast<std::uint32_t>(MaskBits(di, is_narrow));
  block.drawn |= drawn << at;
  block.inside |= inside << at;
  block.near |= near << at;
  const auto is_stepped = hn::Le(farthest, hn::Set(d, kSteppedSide));
  block.stepped |= static_cast<std::uint32_t>(MaskBits(d, is_stepped)) << at;
  block.far |= static_cast<std::uint32_t>(MaskBits(d, is_far)) << at;
  if (near != 0) {
    StoreRelative(c, g.x0, g.y0, at, block);
    StoreNearSlopes(at, block);
  }
  if (near != drawn) StoreFarSlopes(at, block);
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_BLOCK_H_
