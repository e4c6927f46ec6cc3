// Setting up a block of triangles in clip space: facing, box, where rows cross edges, depth.
#ifndef RASTERPROOF_LIBRARY_KERNELS_CLIP_BLOCK_H_
#define RASTERPROOF_LIBRARY_KERNELS_CLIP_BLOCK_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/clip_errors.h"
#include "library/kernels/clip_floats.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Blocks that float32 is not asked of after one of which it told nothing.
constexpr int kLeftOut = 7;

struct alignas(64) ClipBlock {
  /// A row at y crosses edge e at slope y + from, from with 1/2 + the error. A fraction of at least
  /// twice_error, the largest one, tells the column. An edge without a guess cuts nothing
  /// here: CutExactly or ClipRows does. Of edge kNearEdge: where a group of lanes has one in `cut`.
  double slope[4][kBlock], from[4][kBlock], twice_error[kBlock];
  double side[4][kBlock];  ///< infinity: columns from the crossing on are inside; -infinity: before
  double row_of[3][kBlock];  ///< corners' y / w; of `stepped`
  double zc[kBlock], zx[kBlock], zy[kBlock];
  std::int32_t x0[kBlock], x1[kBlock], y0[kBlock], y1[kBlock];
  std::uint64_t masks[kBlock];   ///< of small ones
  NearBlock near_rows;           ///< of those in `near`
  const std::uint32_t* indices;  ///< of the block's triangles
  int left_out = 0;              ///< blocks that float32 is not asked of: see kLeftOut
  // Bit i is triangle i.
  std::uint32_t drawn;
  std::uint32_t front;
  std::uint32_t small;        ///< box at most 8x8, and no row that a guess does not tell
  std::uint32_t near;         ///< begun in float32, by rows
  std::uint32_t stepped;      ///< before the eye, no corner beyond kSteppedSide
  std::uint32_t in_double;    ///< of which edges are set up
  std::uint32_t cut;          ///< by the near plane
  std::uint32_t parallel[3];  ///< to the rows: there is no crossing
  std::uint32_t searched[4];  ///< of the others, and of `cut`, those without a guess

  HWY_INLINE ClipTriangle TriangleOf(const KernelView& view, int i) const {
    ClipTriangle t;
    for (int k = 0; k < 3; ++k) {
      const float* vertex = view.vertices + std::size_t{4} * indices[3 * i + k];
      t.x[k] = vertex[0];
      t.y[k] = vertex[1];
      t.z[k] = vertex[2];
      t.w[k] = vertex[3];
    }
    t.near_plane = view.near_plane;
    return t;
  }
  HWY_INLINE Box BoxOf(int i) const { return {x0[i], x1[i], y0[i], y1[i]}; }
  HWY_INLINE ClipPlane PlaneOf(int i) const { return {zc[i], zx[i], zy[i]}; }
  HWY_INLINE bool Has(std::uint32_t bits, int i) const { return ((bits >> i) & 1) != 0; }
};

/// Vertices that are loaded at once.
constexpr int kClipLoad = Greatest(kDoubles, 4);

/// x, y, z and w of the vertices at vertex(0), vertex(1), ...
template <class VertexAt>
HWY_INLINE void LoadClipVertices(const VertexAt& vertex, float (&of)[4][kClipLoad]) {
#if HWY_TARGET == HWY_SCALAR
  for (int c = 0; c < 4; ++c) of[c][0] = vertex(0)[c];
#else
  const hn::FixedTag<float, 4> four;
  const hn::FixedTag<double, 2> two;
  const auto low = [&](auto first, auto second) {
    return hn::BitCast(four,
                       hn::InterleaveLower(two, hn::BitCast(two, first), hn::BitCast(two, second)));
  };
  const auto high = [&](auto first, auto second) {
    return hn::BitCast(four,
                       hn::InterleaveUpper(two, hn::BitCast(two, first), hn::BitCast(two, second)));
  };
  // Four at a time; where there are two lanes, those two twice.
  constexpr int kNext = kDoubles < 4 ? 0 : 2;
  for (int i = 0; i < kDoubles; i += 4) {
    const auto a = hn::LoadU(four, vertex(i));
    const auto b = hn::LoadU(four, vertex(i + 1));
    const auto c = hn::LoadU(four, vertex(i + kNext));
    const auto d = hn::LoadU(four, vertex(i + kNext + 1));
    const auto xy01 = hn::InterleaveLower(four, a, b);
    const auto xy23 = hn::InterleaveLower(four, c, d);
    const auto zw01 = hn::InterleaveUpper(four, a, b);
    const auto zw23 = hn::InterleaveUpper(four, c, d);
    hn::Store(low(xy01, xy23), four, of[0] + i);
    hn::Store(high(xy01, xy23), four, of[1] + i);
    hn::Store(low(zw01, zw23), four, of[2] + i);
    hn::Store(high(zw01, zw23), four, of[3] + i);
  }
#endif
}

using VDI = hn::Vec<DDI>;

/// The corners of one group of lanes in double.
struct ClipGroup {
  VD x[3], y[3], z[3], w[3];

  HWY_INLINE ClipGroup(const float* vertices, const std::uint32_t* indices) {
    const DD dd;
    const DDF df;
    for (int k = 0; k < 3; ++k) {
      alignas(64) float of[4][kClipLoad];
      LoadClipVertices([&](int i) { return vertices + std::size_t{4} * indices[3 * i + k]; }, of);
      x[k] = hn::PromoteTo(dd, hn::Load(df, of[0]));
      y[k] = hn::PromoteTo(dd, hn::Load(df, of[1]));
      z[k] = hn::PromoteTo(dd, hn::Load(df, of[2]));
      w[k] = hn::PromoteTo(dd, hn::Load(df, of[3]));
    }
  }
};

/// N = V_j x V_i of each lane.
struct ClipNormals {
  VD x, y, w;

  HWY_INLINE ClipNormals(VD x_, VD y_, VD w_) : x(x_), y(y_), w(w_) {}
  HWY_INLINE ClipNormals(const ClipGroup& g, int i, int j) {
    // Products are exact: a fused difference is the same.
    x = hn::Sub(hn::Mul(g.y[j], g.w[i]), hn::Mul(g.w[j], g.y[i]));
    y = hn::Sub(hn::Mul(g.w[j], g.x[i]), hn::Mul(g.x[j], g.w[i]));
    w = hn::Sub(hn::Mul(g.x[j], g.y[i]), hn::Mul(g.y[j], g.x[i]));
  }
};

constexpr std::uint32_t kAllDoubles = (1U << kDoubles) - 1;

HWY_INLINE std::uint32_t Bits32(MD mask) {
  return static_cast<std::uint32_t>(MaskBits(DD(), mask));
}

/// Lanes whose x, y and w (and z where it decides) are finite, and which lie before the eye and the
/// near plane, if perhaps in part. `cut` are those that the near plane cuts.
HWY_INLINE MD MayBeSeen(const KernelView& view, const ClipGroup& g, MD& cut) {
  const DD dd;
  const VD zero = hn::Zero(dd);
  VD sum = zero;  // 0 of finite numbers, NaN of others
  VD before = hn::Set(dd, -1.0);
  for (int k = 0; k < 3; ++k) {
    for (const VD v : {g.x[k], g.y[k], g.w[k]}) sum = hn::Add(sum, hn::Sub(v, v));
    before = hn::Max(before, g.w[k]);
  }
  MD seen = hn::Gt(before, zero);
  cut = hn::Lt(zero, zero);
  if (view.near_plane != NearPlane::kNone) {
    MD all = hn::Eq(zero, zero);
    MD any = cut;
    for (int k = 0; k < 3; ++k) {
      sum = hn::Add(sum, hn::Sub(g.z[k], g.z[k]));
      // Rounded, a sum has its sign.
      const VD n = view.near_plane == NearPlane::kMinusW ? hn::Add(g.z[k], g.w[k]) : g.z[k];
      all = hn::And(all, hn::Ge(n, zero));
      any = hn::Or(any, hn::Ge(n, zero));
    }
    seen = hn::And(seen, any);
    cut = hn::AndNot(all, any);
  }
  return hn::And(seen, hn::Eq(sum, zero));
}

/// Stores the boxes of the projected corners of the lanes `wanted`; of triangles that reach to or
/// past the eye's plane the whole target. Returns the lanes whose boxes hold a sample.
HWY_INLINE MD StoreClipBox(const KernelView& view, const ClipGroup& g, std::uint32_t wanted, int at,
                           ClipBlock& block) {
  const DD dd;
  const DDI di;
  const VD zero = hn::Zero(dd);
  const VD least_w = hn::Min(hn::Min(g.w[0], g.w[1]), g.w[2]);
  const MD before = hn::Gt(least_w, zero);
  VD reciprocal[3];
  for (int k = 0; k < 3; ++k) reciprocal[k] = hn::Div(hn::Set(dd, 1.0), g.w[k]);
  MD stepped = before;
  const auto store = [&](const VD(&v)[3], int first, int size, std::int32_t* from,
                         std::int32_t* to) {
    const VD a = hn::Mul(v[0], reciprocal[0]);
    const VD b = hn::Mul(v[1], reciprocal[1]);
    const VD c = hn::Mul(v[2], reciprocal[2]);
    // Quotients are off by 2u: the slack is 8u, and 2^-50 pixels for the sum's own rounding.
    const auto slack = [&](VD v_) {
      return hn::MulAdd(hn::Abs(v_), hn::Set(dd, 0x1p-50), hn::Set(dd, 0x1p-50));
    };
    const VD low = hn::Min(hn::Min(a, b), c);
    const VD high = hn::Max(hn::Max(a, b), c);
    const VD half = hn::Set(dd, 0.5);
    const VD farthest = hn::Max(hn::Abs(low), hn::Abs(high));
    stepped = hn::And(stepped, hn::Le(farthest, hn::Set(dd, double{kSteppedSide})));
    const VD limit = hn::Set(dd, static_cast<double>(size));
    const VD start = hn::Set(dd, static_cast<double>(first));
    const auto within = [&](VD v_) { return hn::Min(hn::Max(v_, start), limit); };
    const VD begin = hn::Ceil(within(hn::Sub(hn::Sub(low, slack(low)), half)));
    const VD end = hn::Ceil(within(hn::Add(hn::Add(high, slack(high)), half)));
    const auto put = [&](VD v_, std::int32_t* p) {
      auto of = hn::DemoteTo(di, v_);
      if (HWY_UNLIKELY(wanted != kAllDoubles)) {
        of = hn::IfThenElse(MaskOf(di, wanted), of, hn::Load(di, p + at));
      }
      hn::Store(of, di, p + at);
    };
    put(hn::IfThenElse(before, begin, start), from);
    put(hn::IfThenElse(before, end, limit), to);
    return hn::Or(hn::Lt(begin, end), hn::Not(before));
  };
  const MD columns = store(g.x, 0, view.width, block.x0, block.x1);
  const MD rows = store(g.y, view.first_row, view.height, block.y0, block.y1);
  for (int k = 0; k < 3; ++k) {
    hn::Store(hn::Mul(g.y[k], reciprocal[k]), dd, block.row_of[k] + at);
  }
  block.stepped |= Bits32(stepped) << at;
  return hn::And(columns, rows);
}

/// Stores where rows cross edge e of the lanes `cuts`; error_of(unit, rows, reciprocal) is that of
/// the guess. Returns twice the error.
template <class ErrorOf>
HWY_INLINE VD StoreCrossing(const KernelView& view, const ClipNormals& n, MD front, MD cuts, int e,
                            int at, ClipBlock& block, const ErrorOf& error_of) {
  const DD dd;
  const VD reciprocal = hn::Div(hn::Set(dd, -1.0), n.x);
  const VD slope = hn::Mul(n.y, reciprocal);
  const VD from = hn::Mul(n.w, reciprocal);
  const VD rows = hn::Set(dd, static_cast<double>(view.height));
  const VD unit = hn::Add(hn::MulAdd(hn::Abs(slope), rows, hn::Abs(from)), hn::Set(dd, 1.0));
  const VD error = error_of(unit, rows, reciprocal);
  const MD tells = hn::And(cuts, hn::Lt(error, hn::Set(dd, kClipWorstGuess)));  // not if NaN
  const MD is_left = hn::Or(hn::Not(tells), hn::Xor(hn::Lt(n.x, hn::Zero(dd)), front));
  const VD infinity = hn::Set(dd, __builtin_inf());
  // Nothing is before the column of -3/4.
  const VD offset = hn::Add(from, hn::Add(hn::Set(dd, 0.5), error));
  hn::Store(hn::IfThenElseZero(tells, slope), dd, block.slope[e] + at);
  hn::Store(hn::IfThenElse(tells, offset, hn::Set(dd, -0.75)), dd, block.from[e] + at);
  hn::Store(hn::IfThenElse(is_left, infinity, hn::Neg(infinity)), dd, block.side[e] + at);
  block.searched[e] |= Bits32(hn::AndNot(tells, cuts)) << at;
  return hn::IfThenElseZero(tells, hn::Add(error, error));
}

HWY_INLINE VD StoreClipEdge(const KernelView& view, const ClipNormals& n, MD front, int e, int at,
                            ClipBlock& block) {
  const DD dd;
  const MD crosses = hn::Ne(n.x, hn::Zero(dd));
  block.parallel[e] |= Bits32(hn::Not(crosses)) << at;
  return StoreCrossing(view, n, front, crosses, e, at, block, [&](VD unit, VD, VD) {
    return hn::Mul(unit, hn::Set(dd, kClipCrossingError));
  });
}

/// The same of the near plane, of the lanes that it cuts.
HWY_INLINE VD StoreNearEdge(const KernelView& view, const ClipGroup& g, const ClipNormals (&n)[3],
                            MD front, MD cut, int at, ClipBlock& block) {
  const DD dd;
  VD factor[3];
  for (int k = 0; k < 3; ++k) {
    factor[k] = view.near_plane == NearPlane::kMinusW ? hn::Add(g.z[k], g.w[k]) : g.z[k];
  }
  // Corner k is opposite edge k + 1.
  const auto sum = [&](VD a, VD b, VD c, VD& size) {
    const VD terms[3] = {hn::Mul(factor[0], b), hn::Mul(factor[1], c), hn::Mul(factor[2], a)};
    size = hn::Add(hn::Add(hn::Abs(terms[0]), hn::Abs(terms[1])), hn::Abs(terms[2]));
    return hn::Add(hn::Add(terms[0], terms[1]), terms[2]);
  };
  VD size_x, size_y, size_w;
  const ClipNormals near{sum(n[0].x, n[1].x, n[2].x, size_x), sum(n[0].y, n[1].y, n[2].y, size_y),
                         sum(n[0].w, n[1].w, n[2].w, size_w)};
  const auto error_of = [&](VD unit, VD rows, VD reciprocal) {
    const VD sizes = hn::MulAdd(size_x, unit, hn::MulAdd(size_y, rows, size_w));
    const VD moved =
        hn::Mul(hn::Mul(sizes, hn::Abs(reciprocal)), hn::Set(dd, kClipNearCrossingError));
    return hn::MulAdd(unit, hn::Set(dd, kClipCrossingError), moved);
  };
  return StoreCrossing(view, near, front, cut, kNearEdge, at, block, error_of);
}

/// D of each lane, its sign certain; and if kNeedsPlane within a relative 2^-24.6.
template <bool kNeedsPlane>
HWY_INLINE VD ClipDeterminants(const KernelView& view, const ClipGroup& g, const ClipNormals& n,
                               std::uint32_t needed, int at, const ClipBlock& block) {
  const DD dd;
  const VD by_x = hn::Mul(g.x[0], n.x);
  const VD by_y = hn::Mul(g.y[0], n.y);
  const VD by_w = hn::Mul(g.w[0], n.w);
  const VD value = hn::Add(hn::Add(by_x, by_y), by_w);
  const VD sizes = hn::Add(hn::Add(hn::Abs(by_x), hn::Abs(by_y)), hn::Abs(by_w));
  constexpr double kLeast = kNeedsPlane ? kClipPlainDeterminant : kClipDotError;
  // Without a term there is no doubt: nothing underflows.
  const MD certain = hn::Or(hn::Gt(hn::Abs(value), hn::Mul(sizes, hn::Set(dd, kLeast))),
                            hn::Eq(sizes, hn::Zero(dd)));
  std::uint32_t open = needed & ~Bits32(certain);
  if (HWY_LIKELY(open == 0)) return value;
  alignas(64) double values[kDoubles];
  hn::Store(value, dd, values);
  for (; open != 0; open &= open - 1) {
    const int lane = CountTrailingZeros(open);
    values[lane] = ClipDeterminant(block.TriangleOf(view, at + lane));
  }
  return hn::Load(dd, values);
}

/// Stores the coefficients of z / w, NaN if a z is not finite. Nothing is fused: every target
/// computes the same.
HWY_INLINE void StoreClipPlane(const ClipGroup& g, const ClipNormals (&n)[3], VD determinant,
                               int at, ClipBlock& block) {
  const DD dd;
  // Corner k is opposite edge k + 1.
  const auto sum = [&](VD a, VD b, VD c) {
    const VD two = hn::Add(hn::Mul(g.z[0], b), hn::Mul(g.z[1], c));
    return hn::Div(hn::Add(two, hn::Mul(g.z[2], a)), determinant);
  };
  VD zero = hn::Zero(dd);
  for (const VD z : g.z) zero = hn::Add(zero, hn::Sub(z, z));
  hn::Store(sum(n[0].x, n[1].x, n[2].x), dd, block.zx + at);
  hn::Store(sum(n[0].y, n[1].y, n[2].y), dd, block.zy + at);
  hn::Store(hn::Add(zero, sum(n[0].w, n[1].w, n[2].w)), dd, block.zc + at);
}

/// Lanes whose box is at most 8x8; `rows` is the height of the tallest of them.
HWY_INLINE MD AreSmall(const ClipBlock& block, int at, MD drawn, int& rows) {
  const DD dd;
  const DDI di;
  const VDI width = hn::Sub(hn::Load(di, block.x1 + at), hn::Load(di, block.x0 + at));
  const VDI height = hn::Sub(hn::Load(di, block.y1 + at), hn::Load(di, block.y0 + at));
  const VD side = hn::PromoteTo(dd, hn::Max(width, height));
  const MD small = hn::And(drawn, hn::Lt(side, hn::Set(dd, 9.0)));
  rows = static_cast<int>(
      hn::GetLane(hn::MaxOfLanes(dd, hn::IfThenElseZero(small, hn::PromoteTo(dd, height)))));
  return small;
}

/// Finds the masks of small triangles, one a lane. Returns the lanes whose every guess tells.
template <int kEdges>
HWY_INLINE MD FindClipMasks(MD small, int rows, int at, ClipBlock& block) {
  const DD dd;
  const DDI di;
  const hn::Rebind<std::uint64_t, DD> du;
  const hn::Rebind<std::uint32_t, DD> dn;
  VD slope[kEdges], from[kEdges], side[kEdges];
  for (int e = 0; e < kEdges; ++e) {
    slope[e] = hn::Load(dd, block.slope[e] + at);
    from[e] = hn::Load(dd, block.from[e] + at);
    side[e] = hn::Load(dd, block.side[e] + at);
  }
  const auto load = [&](const std::int32_t* p) { return hn::PromoteTo(dd, hn::Load(di, p + at)); };
  const VD begin = load(block.x0);
  const VD end = load(block.x1);
  // Beyond these a guess tells, as their fractions do.
  const VD half = hn::Set(dd, 0.5);
  const VD least = hn::Sub(begin, half);
  const VD most = hn::Add(end, half);
  const VD last_y = hn::Sub(load(block.y1), half);
  VD y = hn::Add(load(block.y0), half);
  VD fraction = half;
  auto mask = hn::Zero(du);
  const auto one = hn::Set(du, std::uint64_t{1});
  const auto ends = [&](VD column) {
    const auto n = hn::BitCast(dn, hn::DemoteTo(di, hn::Sub(column, begin)));
    return hn::Shl(one, hn::PromoteTo(du, n));
  };
  for (int r = 0; r < rows; ++r) {
    const MD valid = hn::Le(y, last_y);
    VD first = begin;
    VD last = end;
    for (int e = 0; e < kEdges; ++e) {
      const VD guess = hn::Min(hn::Max(hn::MulAdd(y, slope[e], from[e]), least), most);
      const VD column = hn::Floor(guess);
      fraction = hn::Min(fraction, hn::IfThenElse(valid, hn::Sub(guess, column), half));
      first = hn::Max(first, hn::Min(column, side[e]));  // by sides of infinity, without a branch
      last = hn::Min(last, hn::Max(column, side[e]));
    }
    first = hn::Min(hn::Max(first, begin), end);
    last = hn::IfThenElse(valid, hn::Max(first, last), first);
    mask = hn::Or(mask, hn::ShiftLeftSame(hn::Sub(ends(last), ends(first)), 8 * r));
    y = hn::Add(y, hn::Set(dd, 1.0));
  }
  const auto old = hn::Load(du, block.masks + at);
  hn::Store(hn::IfThenElse(hn::RebindMask(du, small), mask, old), du, block.masks + at);
  return hn::And(small, hn::Ge(fraction, hn::Load(dd, block.twice_error + at)));
}

/// Sets up one group of lanes in double: the lanes of `wanted`, planes of those that float32 drew,
/// and if any is wanted or with_edges the edges of all.
template <bool kNeedsPlane>
HWY_INLINE void SetUpGroup(const KernelView& view, std::uint32_t wanted, bool with_edges, int at,
                           ClipBlock& block) {
  const DD dd;
  const ClipGroup g(view.vertices, block.indices + 3 * at);
  MD cut = MaskOf(dd, 0);
  std::uint32_t drawn = 0;
  if (wanted != 0) {
    const MD seen = MayBeSeen(view, g, cut);
    drawn = wanted & Bits32(hn::And(seen, StoreClipBox(view, g, wanted, at, block)));
  }
  const std::uint32_t needed =
      drawn | (((kNeedsPlane ? block.drawn : block.near) >> at) & kAllDoubles);
  with_edges |= drawn != 0;
  if (needed == 0) return;
  const ClipNormals n[3] = {{g, 0, 1}, {g, 1, 2}, {g, 2, 0}};
  const VD determinant = ClipDeterminants<kNeedsPlane>(view, g, n[1], needed, at, block);
  if constexpr (kNeedsPlane) StoreClipPlane(g, n, determinant, at, block);
  if (!with_edges) return;
  const MD is_front = hn::Gt(determinant, hn::Zero(dd));
  drawn &= Bits32(hn::Ne(determinant, hn::Zero(dd)));
  block.drawn |= drawn << at;
  block.front |= (Bits32(is_front) & needed) << at;
  block.in_double |= kAllDoubles << at;
  const std::uint32_t cut_bits = drawn & Bits32(cut);
  block.cut |= cut_bits << at;
  VD twice_error = hn::Zero(dd);
  for (int e = 0; e < 3; ++e) {
    twice_error = hn::Max(twice_error, StoreClipEdge(view, n[e], is_front, e, at, block));
  }
  if (HWY_UNLIKELY(cut_bits != 0)) {
    twice_error = hn::Max(twice_error, StoreNearEdge(view, g, n, is_front, cut, at, block));
  }
  hn::Store(twice_error, dd, block.twice_error + at);
  std::uint32_t others = block.searched[kNearEdge];
  for (int e = 0; e < 3; ++e) others |= block.parallel[e] | block.searched[e];
  int rows = 0;
  const MD small = AreSmall(block, at, MaskOf(dd, drawn & ~(others >> at)), rows);
  if (rows == 0) return;
  const MD told = HWY_UNLIKELY(cut_bits != 0) ? FindClipMasks<4>(small, rows, at, block)
                                              : FindClipMasks<3>(small, rows, at, block);
  block.small |= Bits32(told) << at;
}

/// Sets up those triangles of a block that are not `done`, and planes of those drawn.
template <bool kNeedsPlane>
HWY_NOINLINE void SetUpInDouble(const KernelView& view, std::uint32_t done, ClipBlock& block) {
  for (int at = 0; at < kBlock; at += kDoubles) {
    const std::uint32_t wanted = (~done >> at) & kAllDoubles;
    const std::uint32_t drawn = kNeedsPlane ? (block.drawn >> at) & kAllDoubles : 0;
    if ((wanted | drawn) != 0) SetUpGroup<kNeedsPlane>(view, wanted, false, at, block);
  }
}

template <bool kNeedsPlane, bool kNeedsFacing>
HWY_INLINE void SetUpClip(const KernelView& view, const std::uint32_t* indices, ClipBlock& block) {
  block.indices = indices;
  block.cut = 0;
  block.small = 0;
  block.near = 0;
  block.near_rows.odd = 0;
  block.stepped = 0;
  block.in_double = 0;
  for (int e = 0; e < 3; ++e) block.parallel[e] = block.searched[e] = 0;
  block.searched[kNearEdge] = 0;
  std::uint32_t done = 0;
  if (block.left_out > 0) {
    --block.left_out;
  } else {
    for (int at = 0; at < kBlock; at += kLanes) {
      done |= SetUpFloats<kNeedsFacing>(view, indices + 3 * at, at, block) << at;
    }
    if (done == 0) block.left_out = kLeftOut;
  }
  constexpr std::uint32_t kAll = (1U << kBlock) - 1;
  if (done != kAll || kNeedsPlane) SetUpInDouble<kNeedsPlane>(view, done, block);
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_CLIP_BLOCK_H_
