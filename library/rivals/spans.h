// Traversal::kSpans: the spans between the crossings of a triangle's edges with the rows of pixel
// centres, in float32 or float64.
//
// With corners sorted by y, the row of centres at height y meets the long edge and, while y < y1,
// the upper short one, else the lower. Of an edge from its upper end (xa, ya), with one division a
// slope s = (xb - xa) / (yb - ya), x of the crossing is, less 1/2,
//   direct   (xa - 1/2) + (y - ya) s
//   affine   ((xa - 1/2) - ya s) + y s
//   stepped  c + (y - y') s, where c is the direct one of the edge's first row, at y'
// rounded up and kept within the box; in float64 each sum with its product is fused. The row's span
// lies between its two crossings, half-open: so top-left without a test. Both triangles at an edge
// compute the same numbers, from its sorted ends, and keep them within their own boxes: a crossing
// rounded beyond the edge's lower end leaves a pixel to neither. Of float32 that happens, and none
// was seen in float64 (rivals_test).
#ifndef RASTERPROOF_LIBRARY_RIVALS_SPANS_H_
#define RASTERPROOF_LIBRARY_RIVALS_SPANS_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/exact_small.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/reals.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The two short edges and the long one.
enum ScanEdge : int { kUpper, kLower, kLong };

template <class T>
struct alignas(64) SpanBlock : Block {
  T from[3][kBlock], slope[3][kBlock];
  T top[2][kBlock];  ///< where the long and the upper edge are at `from`; the lower one
  std::int32_t middle_row[kBlock];  ///< the first row at or below the middle corner
  std::uint32_t inside;             ///< wholly on the target
  std::uint64_t masks[kBlock];  ///< of small ones: coverage of the 8x8 pixels from the box's corner
};

/// Sorts two corners by y. Returns the lanes in which they were swapped.
template <class V>
HWY_INLINE auto SortPair(V& ya, V& yb, V& xa, V& xb) {
  const auto swap = hn::Lt(yb, ya);
  const V y = hn::IfThenElse(swap, yb, ya);
  const V x = hn::IfThenElse(swap, xb, xa);
  yb = hn::IfThenElse(swap, ya, yb);
  xb = hn::IfThenElse(swap, xa, xb);
  ya = y;
  xa = x;
  return swap;
}

/// An edge's crossing with the row `below` where it is at `from`.
template <class D>
HWY_INLINE hn::Vec<D> Along(D d, hn::Vec<D> from, hn::Vec<D> below, hn::Vec<D> slope) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
    return hn::Add(from, hn::Mul(below, slope));
  } else {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, __builtin_fma(below.raw, slope.raw, from.raw));
#else
    (void)d;
    return hn::MulAdd(below, slope, from);
#endif
  }
}

/// Sorted corners of a group of kLanes triangles, in memory: T may have fewer lanes.
struct alignas(64) SortedGroup {
  float x[3][kLanes], y[3][kLanes];
  float first[2][kLanes];  ///< the first rows at or below the upper and the middle corner
};

/// The edges of triangles at + h on. Returns which of them turn counter-clockwise as sorted, and
/// which have an area.
template <class T, Form kForm>
HWY_INLINE void SetUpSpanEdges(const SortedGroup& g, int at, int h, SpanBlock<T>& block,
                               std::uint64_t& front, std::uint64_t& has_area) {
  const RealTag<T> d;
  using V = RealVec<T>;
  const V half = hn::Set(d, T{0.5});
  V x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = LoadReals<T>(g.x[k] + h);
    y[k] = LoadReals<T>(g.y[k] + h);
  }
  if constexpr (sizeof(T) == sizeof(double)) {
    const V area = TwiceArea(x, y);
    front |= MaskBits(d, hn::Gt(area, hn::Zero(d))) << h;
    has_area |= HasArea(d, area) << h;
  }
  V top[2] = {y[0], y[1]};
  if constexpr (kForm == Form::kStepped) {
    for (int k = 0; k < 2; ++k) top[k] = hn::Add(LoadReals<T>(g.first[k] + h), half);
  }
  constexpr int kEnds[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  for (int k = 0; k < 3; ++k) {
    const int a = kEnds[k][0];
    const int b = kEnds[k][1];
    const V slope = hn::Div(hn::Sub(x[b], x[a]), hn::Sub(y[b], y[a]));
    V from = hn::Sub(x[a], half);
    if constexpr (kForm == Form::kAffine) from = Along(d, from, hn::Neg(y[a]), slope);
    if constexpr (kForm == Form::kStepped) from = Along(d, from, hn::Sub(top[a], y[a]), slope);
    hn::Store(from, d, block.from[k] + at + h);
    hn::Store(slope, d, block.slope[k] + at + h);
  }
  for (int k = 0; k < 2; ++k) hn::Store(top[k], d, block.top[k] + at + h);
}

template <class T, Form kForm, bool kWithZ>
HWY_NOINLINE void SetUpSpans(const KernelView& view, const std::uint32_t* indices,
                             SpanBlock<T>& block) {
  const DF d;
  const DI di;
  block.inside = 0;
  SortedGroup g;
  for (int at = 0; at < kBlock; at += kLanes) {
    Corners<VF> c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    std::uint64_t front = 0;
    std::uint64_t has_area = 0;
    if constexpr (sizeof(T) == sizeof(float)) {
      const VF area = TwiceArea(c.x, c.y);
      front = MaskBits(d, hn::Gt(area, hn::Zero(d)));
      has_area = HasArea(d, area);
    }
    std::uint64_t odd = 0;
    for (const int k : {0, 1, 0}) {
      odd ^= MaskBits(d, SortPair(c.y[k], c.y[k + 1], c.x[k], c.x[k + 1]));
    }
    const VF least_x = Min3(c.x);
    const VF most_x = Max3(c.x);
    const VI y0 = FirstCentreFrom(d, c.y[0], view.height);
    const std::uint32_t boxed = StoreBox(di, FirstCentreFrom(d, least_x, view.width),
                                         FirstCentreFrom(d, most_x, view.width), y0,
                                         FirstCentreFrom(d, c.y[2], view.height), at, block);
    const auto starts = hn::And(hn::Ge(least_x, hn::Zero(d)), hn::Ge(c.y[0], hn::Zero(d)));
    const auto ends = hn::And(hn::Le(most_x, hn::Set(d, static_cast<float>(view.width))),
                              hn::Le(c.y[2], hn::Set(d, static_cast<float>(view.height))));
    for (int k = 0; k < 3; ++k) {
      hn::Store(c.x[k], d, g.x[k]);
      hn::Store(c.y[k], d, g.y[k]);
    }
    const VI middle = FirstCentreFrom(d, c.y[1], view.height);
    hn::Store(middle, di, block.middle_row + at);
    if constexpr (kForm == Form::kStepped) {
      hn::Store(hn::ConvertTo(d, y0), d, g.first[0]);
      hn::Store(hn::ConvertTo(d, middle), d, g.first[1]);
    }
    for (int h = 0; h < kLanes; h += kReals<T>) {
      SetUpSpanEdges<T, kForm>(g, at, h, block, front, has_area);
    }
    if constexpr (sizeof(T) == sizeof(double)) front ^= odd;
    const std::uint32_t drawn = boxed & static_cast<std::uint32_t>(has_area);
    block.inside |= static_cast<std::uint32_t>(MaskBits(d, hn::And(starts, ends))) << at;
    block.front |= static_cast<std::uint32_t>(front) << at;
    block.drawn |= drawn << at;
  }
  FindSmall(block);
  block.small &= block.inside;
}

/// The edges of one triangle a lane, or of the same one in all.
template <class D, bool kAffine>
struct SpanEdges {
  using V = hn::Vec<D>;
  V from[3], slope[3], top[2];

  /// get(p) makes a vector of what is at p of each triangle of the block.
  template <class Get>
  HWY_INLINE SpanEdges(const SpanBlock<hn::TFromD<D>>& block, const Get& get) {
    for (int k = 0; k < 3; ++k) {
      from[k] = get(block.from[k]);
      slope[k] = get(block.slope[k]);
    }
    for (int k = 0; k < 2; ++k) top[k] = get(block.top[k]);
  }

  /// Where the long edge and the short one cross the row at height y, less 1/2.
  HWY_INLINE void At(V y, V& by_long, V& by_short) const {
    const auto is_upper = hn::Lt(y, top[1]);
    const auto f = hn::IfThenElse(is_upper, from[kUpper], from[kLower]);
    const auto s = hn::IfThenElse(is_upper, slope[kUpper], slope[kLower]);
    const D d;
    if constexpr (kAffine) {
      by_long = Along(d, from[kLong], y, slope[kLong]);
      by_short = Along(d, f, y, s);
    } else {
      const auto below = hn::Sub(y, top[0]);
      const auto below_short = hn::IfThenElse(is_upper, below, hn::Sub(y, top[1]));
      by_long = Along(d, from[kLong], below, slope[kLong]);
      by_short = Along(d, f, below_short, s);
    }
  }
};

/// The crossings of kLanes rows, or of one row of kLanes triangles. at(h, a, b) finds those of the
/// lanes from the h-th on.
template <class T>
struct CrossedRows {
  VI first, last;

  template <class At>
  HWY_INLINE CrossedRows(VI x0, VI x1, const At& at) {
    RealVec<T> by_long[kLanes / kReals<T>], by_short[kLanes / kReals<T>];
    for (int h = 0; h < kLanes; h += kReals<T>) {
      at(h, by_long[h / kReals<T>], by_short[h / kReals<T>]);
    }
    const VI a = hn::Max(CeiledLanes<T>([&](int h) { return by_long[h / kReals<T>]; }), x0);
    const VI b = hn::Max(CeiledLanes<T>([&](int h) { return by_short[h / kReals<T>]; }), x0);
    first = hn::Min(hn::Min(a, b), x1);
    last = hn::Min(hn::Max(a, b), x1);
  }
};

/// Fills in the masks of the small triangles, kLanes of them a row at a time.
template <class T, bool kAffine>
HWY_NOINLINE void FindSmallSpans(SpanBlock<T>& block) {
  const DI di;
  const RealTag<T> d;
  constexpr int kParts = kLanes / kReals<T>;
  using Edges = SpanEdges<RealTag<T>, kAffine>;
  for (int at = 0; at < kBlock; at += kLanes) {
    const std::uint64_t small = (block.small >> at) & ((std::uint64_t{1} << kLanes) - 1);
    if (small == 0) continue;
    const VI x0 = hn::Load(di, block.x0 + at);
    const VI y0 = hn::Load(di, block.y0 + at);
    const VI rows = hn::Sub(hn::Load(di, block.y1 + at), y0);
    // A lane that is not small has a wide box: no shift beyond 8 for it either.
    const VI x1 = hn::Min(hn::Load(di, block.x1 + at), hn::Add(x0, hn::Set(di, 8)));
    RealVec<T> y[kParts];
    for (int part = 0; part < kParts; ++part) {
      y[part] = hn::Add(LoadReals<T>(block.y0 + at + part * kReals<T>), hn::Set(d, T{0.5}));
    }
    VI halves[2] = {hn::Zero(di), hn::Zero(di)};
    const auto add = [&](int row) {
      const CrossedRows<T> crossed(x0, x1, [&](int h, RealVec<T>& a, RealVec<T>& b) {
        const Edges edges(block, [&](const T* p) { return hn::Load(d, p + at + h); });
        edges.At(hn::Add(y[h / kReals<T>], hn::Set(d, static_cast<T>(row))), a, b);
      });
      const VI one = hn::Set(di, 1);
      const VI bits = hn::Sub(hn::Shl(one, hn::Sub(crossed.last, x0)),
                              hn::Shl(one, hn::Sub(crossed.first, x0)));
      const auto covered = hn::Gt(rows, hn::Set(di, row));
      VI& half = halves[row >> 2];
      half = hn::Or(half, hn::ShiftLeftSame(hn::IfThenElseZero(covered, bits), 8 * (row & 3)));
    };
    for (int row = 0; row < 4; ++row) add(row);
    if ((MaskBits(di, hn::Gt(rows, hn::Set(di, 4))) & small) != 0) {
      for (int row = 4; row < 8; ++row) add(row);
    }
    StoreMasks(halves, block.masks + at);
  }
}

/// Draws rows [begin, end) of a triangle, kLanes at a time. kInside: it is wholly on the target.
/// at(y, a, b) finds where they cross the long edge and the short one.
template <class T, bool kInside, class Sink, class At>
HWY_INLINE void DrawSpanRowsOf(const Box& box, int begin, int end, Sink& sink, const At& at) {
  const DI di;
  const RealTag<T> d;
  const VI x0 = hn::Set(di, box.x0);
  const VI x1 = hn::Set(di, box.x1);
  for (int row = begin; row < end; row += kLanes) {
    const CrossedRows<T> crossed(x0, x1, [&](int h, RealVec<T>& a, RealVec<T>& b) {
      at(RealsFrom(static_cast<T>(row + h) + T{0.5}), a, b);
      if constexpr (!kInside) {  // of what is no number, x0
        const auto least = hn::Set(d, static_cast<T>(box.x0));
        const auto most = hn::Set(d, static_cast<T>(box.x1));
        a = hn::Min(hn::Max(a, least), most);
        b = hn::Min(hn::Max(b, least), most);
      }
    });
    EmitRows(sink, box.x1 - box.x0, row, Least(kLanes, end - row), crossed.first, crossed.last);
  }
}

template <class T, bool kAffine, bool kInside, class Sink>
HWY_NOINLINE void DrawSpanRows(const SpanBlock<T>& block, int i, Sink sink) {
  const RealTag<T> d;
  using V = RealVec<T>;
  const Box box = block.BoxOf(i);
  const SpanEdges<RealTag<T>, kAffine> edges(block, [&](const T* p) { return hn::Set(d, p[i]); });
  DrawSpanRowsOf<T, kInside>(box, box.y0, box.y1, sink,
                             [&](V y, V& a, V& b) { edges.At(y, a, b); });
}

/// Triangles of more rows are drawn in two halves, so that no row chooses its short edge.
constexpr int kTall = 32;

/// The rows [begin, end) of a triangle on the target, which all meet the short edge `edge`.
template <class T, bool kAffine, class Sink>
HWY_NOINLINE void DrawTallRows(const SpanBlock<T>& block, int i, int edge, int begin, int end,
                               Sink sink) {
  const RealTag<T> d;
  using V = RealVec<T>;
  const V from[2] = {hn::Set(d, block.from[kLong][i]), hn::Set(d, block.from[edge][i])};
  const V slope[2] = {hn::Set(d, block.slope[kLong][i]), hn::Set(d, block.slope[edge][i])};
  const V top[2] = {hn::Set(d, block.top[0][i]), hn::Set(d, block.top[edge][i])};
  DrawSpanRowsOf<T, true>(block.BoxOf(i), begin, end, sink, [&](V y, V& a, V& b) {
    a = Along(d, from[0], kAffine ? y : hn::Sub(y, top[0]), slope[0]);
    b = Along(d, from[1], kAffine ? y : hn::Sub(y, top[1]), slope[1]);
  });
}

template <class T, bool kAffine, class Sink>
HWY_INLINE void DrawLarge(const SpanBlock<T>& block, int i, const Sink& sink) {
  const Box box = block.BoxOf(i);
  if (((block.inside >> i) & 1) == 0) {
    DrawSpanRows<T, kAffine, false>(block, i, sink);
  } else if (box.y1 - box.y0 <= kTall) {
    DrawSpanRows<T, kAffine, true>(block, i, sink);
  } else {
    const int middle = Least(Greatest(block.middle_row[i], box.y0), box.y1);
    DrawTallRows<T, kAffine>(block, i, kUpper, box.y0, middle, sink);
    DrawTallRows<T, kAffine>(block, i, kLower, middle, box.y1, sink);
  }
}

template <class T, Form kForm, class Sink>
void DrawSpans(const KernelView& view) {
  constexpr bool kAffine = kForm == Form::kAffine;
  Sink sink(view);
  SpanBlock<T> block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpSpans<T, kForm, Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallSpans<T, kAffine>(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          if (block.masks[i] != 0) sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
        } else {
          DrawLarge<T, kAffine>(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_SPANS_H_
