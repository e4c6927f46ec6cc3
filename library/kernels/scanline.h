// kScanline: float32 crossings of the edges with the rows of pixel centres.
//
// With corners sorted by y, the row of centres at height y meets the long edge and, while y < y1,
// the upper short one, else the lower. At an edge from (xa, ya), slope s = dx / dy, the crossing is
//   k = ceil((xa - 1/2) + (y - ya) s), kept within the box,
// and the row's span lies between its two crossings: half-open, so top-left without a test.
#ifndef RASTERPROOF_LIBRARY_KERNELS_SCANLINE_H_
#define RASTERPROOF_LIBRARY_KERNELS_SCANLINE_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The two short edges and the long one.
enum ScanEdge : int { kUpper, kLower, kLong };

struct alignas(64) ScanBlock : Block {
  float middle[kBlock];  ///< y of the corner between the short edges
  float xa[3][kBlock], ya[3][kBlock], slope[3][kBlock];  ///< xa: minus 1/2
  std::uint64_t masks[kBlock];  ///< of small ones: coverage of the 8x8 pixels from the box's corner
};

template <class V>
HWY_INLINE void SortPair(V& ya, V& yb, V& xa, V& xb) {
  const auto swap = hn::Lt(yb, ya);
  const V y = hn::IfThenElse(swap, yb, ya);
  const V x = hn::IfThenElse(swap, xb, xa);
  yb = hn::IfThenElse(swap, ya, yb);
  xb = hn::IfThenElse(swap, xa, xb);
  ya = y;
  xa = x;
}

template <bool kWithZ>
HWY_INLINE void SetUpScan(const KernelView& view, const std::uint32_t* indices, ScanBlock& block) {
  const DF d;
  const DI di;
  const VF zero = hn::Zero(d);
  const VF half = hn::Set(d, 0.5F);
  for (int at = 0; at < kBlock; at += kLanes) {
    Corners<VF> c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    const VF area = hn::Sub(hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])),
                            hn::Mul(hn::Sub(c.y[2], c.y[0]), hn::Sub(c.x[1], c.x[0])));
    const auto has_area =
        hn::And(hn::Gt(hn::Abs(area), zero), hn::Lt(hn::Abs(area), hn::Set(d, __builtin_inff())));
    SortPair(c.y[0], c.y[1], c.x[0], c.x[1]);
    SortPair(c.y[1], c.y[2], c.x[1], c.x[2]);
    SortPair(c.y[0], c.y[1], c.x[0], c.x[1]);
    const std::uint32_t boxed =
        StoreBox(di, FirstCentreFrom(d, Min3(c.x), view.width),
                 FirstCentreFrom(d, Max3(c.x), view.width), FirstCentreFrom(d, c.y[0], view.height),
                 FirstCentreFrom(d, c.y[2], view.height), at, block);
    hn::Store(c.y[1], d, block.middle + at);
    constexpr int kEnds[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    for (int k = 0; k < 3; ++k) {
      const int a = kEnds[k][0];
      const int b = kEnds[k][1];
      hn::Store(hn::Sub(c.x[a], half), d, block.xa[k] + at);
      hn::Store(c.y[a], d, block.ya[k] + at);
      hn::Store(hn::Div(hn::Sub(c.x[b], c.x[a]), hn::Sub(c.y[b], c.y[a])), d, block.slope[k] + at);
    }
    block.front |= static_cast<std::uint32_t>(MaskBits(d, hn::Gt(area, zero))) << at;
    block.drawn |= (static_cast<std::uint32_t>(MaskBits(d, has_area)) & boxed) << at;
  }
  FindSmall(block);
}

/// The crossing of one edge, kept within [x0, x1]; x0 of what is no number.
template <class D>
HWY_INLINE hn::Vec<D> Crossing(D /*d*/, hn::Vec<D> y, hn::Vec<D> xa, hn::Vec<D> ya,
                               hn::Vec<D> slope, hn::Vec<D> x0, hn::Vec<D> x1) {
  const auto k = hn::Ceil(hn::Add(xa, hn::Mul(hn::Sub(y, ya), slope)));
  return hn::Min(hn::Max(k, x0), x1);
}

/// The columns [left, right) of rows of one triangle each lane.
template <class D>
struct ScanRows {
  hn::Vec<hn::Rebind<std::int32_t, D>> left, right;
};

/// The edges of one triangle a lane, or of the same one in all.
template <class D>
struct ScanEdges {
  hn::Vec<D> middle, xa[3], ya[3], slope[3], x0, x1;

  HWY_INLINE ScanRows<D> At(D d, hn::Vec<D> y) const {
    const hn::Rebind<std::int32_t, D> di;
    const auto is_upper = hn::Lt(y, middle);
    const auto a = Crossing(d, y, xa[kLong], ya[kLong], slope[kLong], x0, x1);
    const auto b = Crossing(d, y, hn::IfThenElse(is_upper, xa[kUpper], xa[kLower]),
                            hn::IfThenElse(is_upper, ya[kUpper], ya[kLower]),
                            hn::IfThenElse(is_upper, slope[kUpper], slope[kLower]), x0, x1);
    return {hn::ConvertTo(di, hn::Min(a, b)), hn::ConvertTo(di, hn::Max(a, b))};
  }
};

template <class D>
HWY_INLINE ScanEdges<D> EdgesOf(D d, const ScanBlock& block, int i) {
  ScanEdges<D> edges;
  edges.middle = hn::Set(d, block.middle[i]);
  for (int k = 0; k < 3; ++k) {
    edges.xa[k] = hn::Set(d, block.xa[k][i]);
    edges.ya[k] = hn::Set(d, block.ya[k][i]);
    edges.slope[k] = hn::Set(d, block.slope[k][i]);
  }
  edges.x0 = hn::Set(d, static_cast<float>(block.x0[i]));
  edges.x1 = hn::Set(d, static_cast<float>(block.x1[i]));
  return edges;
}

/// Fills in the masks of the small triangles, a row of kLanes triangles at a time.
HWY_INLINE void FindSmallScanMasks(ScanBlock& block) {
  const DF d;
  const DI di;
  const DU du;
  for (int at = 0; at < kBlock; at += kLanes) {
    if (((block.small >> at) & ((std::uint64_t{1} << kLanes) - 1)) == 0) continue;
    ScanEdges<DF> edges;
    edges.middle = hn::Load(d, block.middle + at);
    for (int k = 0; k < 3; ++k) {
      edges.xa[k] = hn::Load(d, block.xa[k] + at);
      edges.ya[k] = hn::Load(d, block.ya[k] + at);
      edges.slope[k] = hn::Load(d, block.slope[k] + at);
    }
    const VI x0 = hn::Load(di, block.x0 + at);
    const VI y0 = hn::Load(di, block.y0 + at);
    const VI rows = hn::Sub(hn::Load(di, block.y1 + at), y0);
    edges.x0 = hn::ConvertTo(d, x0);
    // A lane that is not small has a wide box: no shift beyond 8 for it either.
    edges.x1 =
        hn::Min(hn::ConvertTo(d, hn::Load(di, block.x1 + at)), hn::Add(edges.x0, hn::Set(d, 8.0F)));
    const VF y = hn::Add(hn::ConvertTo(d, y0), hn::Set(d, 0.5F));
    VU halves[2] = {hn::Zero(du), hn::Zero(du)};
    for (int r = 0; r < block.height; ++r) {
      const auto row = edges.At(d, hn::Add(y, hn::Set(d, static_cast<float>(r))));
      const VU left = hn::BitCast(du, hn::Sub(row.left, x0));
      const VU right = hn::BitCast(du, hn::Sub(row.right, x0));
      const VU one = hn::Set(du, 1U);
      const VU all = hn::Sub(hn::Shl(one, right), hn::Shl(one, left));
      const auto in_box = hn::RebindMask(du, hn::Gt(rows, hn::Set(di, r)));
      const VU bits = hn::IfThenElseZero(in_box, all);
      const int half = r >> 2;
      halves[half] = hn::Or(halves[half], hn::ShiftLeftSame(bits, 8 * (r & 3)));
    }
    alignas(64) std::uint32_t low[kLanes], high[kLanes];
    hn::Store(halves[0], du, low);
    hn::Store(halves[1], du, high);
    for (int i = 0; i < kLanes; ++i) {
      block.masks[at + i] = std::uint64_t{low[i]} | (std::uint64_t{high[i]} << 32);
    }
  }
}

/// Draws the rows of a triangle, kLanes crossings at a time. kMost: 16, 32 or 64 where no span is
/// longer, else 0.
template <int kMost, class Sink>
HWY_INLINE void DrawRows(const ScanBlock& block, int i, Sink& sink) {
  const DF d;
  const DI di;
  const Box box = block.BoxOf(i);
  const ScanEdges<DF> edges = EdgesOf(d, block, i);
  for (int y = box.y0; y < box.y1; y += kLanes) {
    const auto rows = edges.At(d, FloatsFrom(d, static_cast<float>(y) + 0.5F));
    alignas(64) std::int32_t left[kLanes], right[kLanes];
    hn::Store(rows.left, di, left);
    hn::Store(rows.right, di, right);
    const int end = Least(kLanes, box.y1 - y);
    for (int r = 0; r < end; ++r) {
      if constexpr (kMost != 0) {
        sink.template ShortSpan<kMost>(y + r, left[r], right[r] - left[r]);
      } else {
        if (left[r] < right[r]) sink.Span(y + r, left[r], right[r]);
      }
    }
  }
}

template <class Sink>
void DrawScanline(const KernelView& view) {
  Sink sink(view);
  ScanBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpScan<Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallScanMasks(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        const int width = block.x1[i] - block.x0[i];
        if (block.IsSmall(i)) {
          if (block.masks[i] != 0) sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
        } else if (width <= 16) {
          DrawRows<16>(block, i, sink);
        } else if (width <= 32) {
          DrawRows<32>(block, i, sink);
        } else if (width <= 64) {
          DrawRows<64>(block, i, sink);
        } else {
          DrawRows<0>(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_SCANLINE_H_
