// Triangles of clip space in float32: those that lie before the eye and the near plane, wholly on
// the target, in a box of at most kNearSide a side.
//
// Projected, and relative to its first pixel, such a triangle is a small or a near one of window
// space but for what its corners are off (clip_errors.h). What guesses do not tell is left to
// doubles (clip_block.h).
#ifndef RASTERPROOF_LIBRARY_KERNELS_CLIP_FLOATS_H_
#define RASTERPROOF_LIBRARY_KERNELS_CLIP_FLOATS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/clip_errors.h"
#include "library/kernels/exact_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/exact_small.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

#if HWY_NATIVE_FMA && HWY_TARGET != HWY_SCALAR
/// x, y, z and w of one corner of consecutive triangles, one a lane.
struct ClipCorner {
  VF x, y, z, w;
};

HWY_INLINE ClipCorner LoadClipCorner(const float* vertices, const std::uint32_t* indices) {
  const DF d;
  const hn::Repartition<double, DF> pairs;
  const auto load = [&](int from) {
    return LoadEvery<4>(d,
                        [&](int i) { return vertices + std::size_t{4} * indices[3 * (from + i)]; });
  };
  const auto low = [&](VF a, VF b) {
    return hn::BitCast(d, hn::InterleaveLower(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
  };
  const auto high = [&](VF a, VF b) {
    return hn::BitCast(d, hn::InterleaveUpper(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
  };
  const VF v0 = load(0);
  const VF v1 = load(1);
  const VF v2 = load(2);
  const VF v3 = load(3);
  const VF xy01 = hn::InterleaveLower(d, v0, v1);
  const VF xy23 = hn::InterleaveLower(d, v2, v3);
  const VF zw01 = hn::InterleaveUpper(d, v0, v1);
  const VF zw23 = hn::InterleaveUpper(d, v2, v3);
  return {low(xy01, xy23), high(xy01, xy23), low(zw01, zw23), high(zw01, zw23)};
}

/// The triangles of one group of lanes, projected.
struct ProjectedGroup {
  Corners<VF> c;             ///< relative to the first pixel of the box, least y first
  VF x0, y0, columns, rows;  ///< the box
  hn::Mask<DF> tells;     ///< the lanes that are of this file, and whose rows and box are certain
  std::uint32_t odd = 0;  ///< sorting swapped two corners an odd number of times

  HWY_INLINE ProjectedGroup(const KernelView& view, const std::uint32_t* indices) {
    const DF d;
    ClipCorner of[3];
    for (int k = 0; k < 3; ++k) of[k] = LoadClipCorner(view.vertices, indices + k);
    const VF least_w = hn::Min(hn::Min(of[0].w, of[1].w), of[2].w);
    const VF most_w = hn::Max(hn::Max(of[0].w, of[1].w), of[2].w);
    tells = hn::And(hn::Ge(least_w, hn::Set(d, 1 / kClipTameW)),
                    hn::Le(most_w, hn::Set(d, kClipTameW)));
    if (view.near_plane != NearPlane::kNone) {
      for (const ClipCorner& v : of) {
        // Rounded, a sum has its sign.
        const VF n = view.near_plane == NearPlane::kMinusW ? hn::Add(v.z, v.w) : v.z;
        tells = hn::And(tells,
                        hn::And(hn::Ge(n, hn::Zero(d)), hn::Lt(n, hn::Set(d, __builtin_inff()))));
      }
    }
    if (MaskBits(d, tells) == 0) return;
    Project(of);
    odd = static_cast<std::uint32_t>(SortByY(c));
    FindBox(view);
  }

 private:
  HWY_INLINE void Project(const ClipCorner (&of)[3]) {
    const DF d;
    const VF half = hn::Set(d, 0.5F);
    VF reciprocal[3], x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      reciprocal[k] = hn::Div(hn::Set(d, 1.0F), of[k].w);
      x[k] = hn::Mul(of[k].x, reciprocal[k]);
      y[k] = hn::Mul(of[k].y, reciprocal[k]);
    }
    x0 = hn::Ceil(hn::Sub(Min3(x), half));
    y0 = hn::Ceil(hn::Sub(Min3(y), half));
    VF sum = hn::Zero(d);  // NaN where a corner is
    for (int k = 0; k < 3; ++k) {
      c.x[k] = hn::Mul(hn::NegMulAdd(of[k].w, x0, of[k].x), reciprocal[k]);
      c.y[k] = hn::Mul(hn::NegMulAdd(of[k].w, y0, of[k].y), reciprocal[k]);
      sum = hn::Add(sum, hn::Add(c.x[k], c.y[k]));
    }
    tells = hn::And(tells, hn::Eq(sum, sum));
  }

  HWY_INLINE void FindBox(const KernelView& view) {
    const DF d;
    const VF half = hn::Set(d, 0.5F);
    const VF room = hn::Set(d, kClipCornerRoom);
    const VF most_x = Max3(c.x);
    columns = hn::Ceil(hn::Sub(most_x, half));
    rows = hn::Ceil(hn::Sub(c.y[2], half));
    VF off = half;  // of corners from centres of rows
    for (const VF y : c.y) {
      const VF below = hn::Sub(y, half);
      off = hn::Min(off, hn::Abs(hn::Sub(below, hn::Round(below))));
    }
    const auto at_most = [&](VF a, VF b, int size) {
      return hn::Le(hn::Add(a, b), hn::Set(d, static_cast<float>(size)));
    };
    const VF end = hn::Max(columns, rows);
    const auto is_near = hn::And(hn::Le(end, hn::Set(d, static_cast<float>(kNearSide))),
                                 hn::And(hn::Ge(off, room), hn::Lt(c.y[0], half)));
    const auto begins =
        hn::And(hn::Ge(hn::Min(Min3(c.x), c.y[0]), hn::Sub(room, half)),
                hn::Le(hn::Add(most_x, hn::Sub(half, columns)), hn::Sub(hn::Set(d, 1.0F), room)));
    const auto starts = hn::And(hn::Ge(x0, hn::Zero(d)),
                                hn::Ge(y0, hn::Set(d, static_cast<float>(view.first_row))));
    const auto ends = hn::And(at_most(x0, columns, view.width), at_most(y0, rows, view.height));
    tells = hn::And(tells, hn::And(hn::And(is_near, begins), hn::And(starts, ends)));
  }
};

/// Masks of small triangles of one group of lanes, found row by row.
template <bool kFacing>
class SmallClipMasks {
 public:
  template <int kFirst>
  HWY_INLINE void AddRows(const SmallEdges& edges) {
    for (int row = kFirst; row < kFirst + 4; ++row) {
      const SmallRow r(edges, row);
      least_ = LesserFractions(least_, LesserFractions(r.by_long, r.by_short));
      steepest_ = hn::Max(steepest_, hn::Abs(r.slope));
      if constexpr (kFacing) {
        const auto is_left =
            hn::Lt(hn::ShiftRight<kSmallBits>(r.by_long), hn::ShiftRight<kSmallBits>(r.by_short));
        long_is_left_ = hn::Or(long_is_left_, hn::And(r.covered, is_left));
      }
      halves_[kFirst / 4] = hn::Or(halves_[kFirst / 4], BitsOfRow(row & 3, r));
    }
  }

  /// Bits of the lanes whose every guess tells.
  HWY_INLINE std::uint64_t Told() const {
    const DF d;
    const auto is_flat = hn::Le(steepest_, hn::Set(d, kClipFloatSlope * kSmallUnit));
    return MaskBits(d, is_flat) &
           ~MaskBits(DI(), HasOpenFraction(least_, 2 * kClipSmallCrossingError));
  }
  HWY_INLINE std::uint64_t LongIsLeft() const { return MaskBits(DI(), long_is_left_); }
  HWY_INLINE void Store(std::uint64_t* masks) const { StoreMasks(halves_, masks); }

 private:
  VF steepest_ = hn::Zero(DF());
  VI least_ = hn::Set(DI(), kSmallFraction);  // fractions
  VI halves_[2] = {hn::Zero(DI()), hn::Zero(DI())};
  hn::Mask<DI> long_is_left_ = hn::Lt(halves_[0], halves_[0]);
};

/// Sets up one group of lanes. Returns those that are done: small ones, near ones and those that
/// cover nothing; of the others nothing is known, and stored any number.
template <bool kFacing, class SomeBlock>
HWY_INLINE std::uint32_t SetUpFloats(const KernelView& view, const std::uint32_t* indices, int at,
                                     SomeBlock& block) {
  const DF d;
  const DI di;
  const ProjectedGroup g(view, indices);
  if (MaskBits(d, g.tells) == 0) return 0;
  const SmallEdges edges(g.c, g.rows, kClipSmallCrossingError);
  const auto is_full = hn::Gt(hn::Min(g.columns, g.rows), hn::Zero(d));
  const auto is_small = hn::Lt(hn::Max(g.columns, g.rows), hn::Set(d, 9.0F));
  const auto is_flat = hn::Le(hn::Abs(edges.whole), hn::Set(d, kClipFloatSlope * kSmallUnit));
  const auto bits = [&](hn::Mask<DF> m) { return static_cast<std::uint32_t>(MaskBits(d, m)); };
  const std::uint32_t nothing = bits(hn::AndNot(is_full, g.tells));
  const std::uint32_t drawn = bits(hn::And(hn::And(g.tells, is_full), is_flat));
  std::uint32_t small = drawn & bits(is_small);
  const std::uint32_t near = drawn & ~small;
  hn::Store(Truncated(g.x0), di, block.x0 + at);
  hn::Store(Truncated(g.y0), di, block.y0 + at);
  if (small != 0) {
    SmallClipMasks<kFacing> masks;
    masks.template AddRows<0>(edges);
    if ((small & bits(hn::Gt(g.rows, hn::Set(d, 4.0F)))) != 0) masks.template AddRows<4>(edges);
    small &= static_cast<std::uint32_t>(masks.Told());
    masks.Store(block.masks + at);
    if constexpr (kFacing) {
      block.front |= (small & ~(static_cast<std::uint32_t>(masks.LongIsLeft()) ^ g.odd)) << at;
    }
    block.small |= small << at;
  }
  if (near != 0) {
    hn::Store(Truncated(hn::Add(g.x0, g.columns)), di, block.x1 + at);
    hn::Store(Truncated(hn::Add(g.y0, g.rows)), di, block.y1 + at);
    NearBlock& n = block.near_rows;
    for (int k = 0; k < 3; ++k) {
      hn::Store(g.c.x[k], d, n.sx[k] + at);
      hn::Store(g.c.y[k], d, n.sy[k] + at);
    }
    const VF unit = hn::Set(d, 1 / kSmallUnit);
    hn::Store(hn::Mul(edges.upper, unit), d, n.slope[kUpperEdge] + at);
    hn::Store(hn::Mul(edges.lower, unit), d, n.slope[kLowerEdge] + at);
    hn::Store(hn::Mul(edges.whole, unit), d, n.slope[kLongEdge] + at);
    n.odd |= g.odd << at;
    block.near |= near << at;
  }
  block.drawn |= (small | near) << at;
  return small | near | nothing;
}
#else
/// Without fused products corners would round twice, and nothing is told.
template <bool kFacing, class SomeBlock>
HWY_INLINE std::uint32_t SetUpFloats(const KernelView& /*view*/, const std::uint32_t* /*indices*/,
                                     int /*at*/, SomeBlock& /*block*/) {
  return 0;
}
#endif

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_CLIP_FLOATS_H_
