// Spans in clip space in float32, nothing divided by w and nothing clipped, as Olano and Greer,
// Triangle scan conversion using 2D homogeneous coordinates (1997), have it.
//
// Edge k from V_k to its successor is N = V_j x V_k of (x, y, w): a X + b Y + c, and what is inside
// all three is before the eye. A row crosses it at Y (-b / a) + (-c / a), less 1/2, rounded up;
// from there on columns are inside, or before it. An edge along the rows, a = 0, cuts rows at
// -c / b. Both triangles at an edge compute the same numbers, and keep them within their own boxes,
// those of x / w and y / w where all w are above 0, else the whole target.
#ifndef RASTERPROOF_LIBRARY_RIVALS_HOMOGENEOUS_H_
#define RASTERPROOF_LIBRARY_RIVALS_HOMOGENEOUS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/clip_block.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/exact_small.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/reals.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

struct alignas(64) HomogeneousBlock : Block {
  float slope[3][kBlock], from[3][kBlock];
  float side[3][kBlock];  ///< infinity: columns from the crossing on are inside; -infinity: before
  std::uint64_t masks[kBlock];
};

/// x, y and w of kLanes triangles.
struct alignas(64) HomogeneousGroup {
  float x[3][kLanes], y[3][kLanes], w[3][kLanes];

  HWY_INLINE HomogeneousGroup(const float* vertices, const std::uint32_t* indices) {
    const DDF df;
    for (int k = 0; k < 3; ++k) {
      for (int h = 0; h < kLanes; h += kDoubles) {
        alignas(64) float of[4][kClipLoad];
        LoadClipVertices(
            [&](int i) { return vertices + std::size_t{4} * indices[3 * (h + i) + k]; }, of);
        hn::Store(hn::Load(df, of[0]), df, x[k] + h);
        hn::Store(hn::Load(df, of[1]), df, y[k] + h);
        hn::Store(hn::Load(df, of[3]), df, w[k] + h);
      }
    }
  }
};

inline HWY_NOINLINE void SetUpHomogeneous(const KernelView& view, const std::uint32_t* indices,
                                          HomogeneousBlock& block) {
  const DF d;
  const DI di;
  const VF zero = hn::Zero(d);
  const VF infinite = hn::Set(d, __builtin_inff());
  for (int at = 0; at < kBlock; at += kLanes) {
    const HomogeneousGroup g(view.vertices, indices + 3 * at);
    VF x[3], y[3], w[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::Load(d, g.x[k]);
      y[k] = hn::Load(d, g.y[k]);
      w[k] = hn::Load(d, g.w[k]);
    }
    // The box of what lies before the eye as a whole.
    const VF px[3] = {hn::Div(x[0], w[0]), hn::Div(x[1], w[1]), hn::Div(x[2], w[2])};
    const VF py[3] = {hn::Div(y[0], w[0]), hn::Div(y[1], w[1]), hn::Div(y[2], w[2])};
    const auto whole = hn::Gt(Min3(w), zero);
    const auto least = [&](VF v) { return hn::IfThenElseZero(whole, v); };
    const auto most = [&](VF v) { return hn::IfThenElse(whole, v, infinite); };
    const VI x0 = FirstCentreFrom(d, least(Min3(px)), view.width);
    const VI x1 = FirstCentreFrom(d, most(Max3(px)), view.width);
    VI y0 = FirstCentreFrom(d, least(Min3(py)), view.height);
    VI y1 = FirstCentreFrom(d, most(Max3(py)), view.height);
    VF a[3], b[3], c[3];
    for (int k = 0; k < 3; ++k) {
      const int j = (k + 1) % 3;
      a[k] = hn::Sub(hn::Mul(y[j], w[k]), hn::Mul(w[j], y[k]));
      b[k] = hn::Sub(hn::Mul(w[j], x[k]), hn::Mul(x[j], w[k]));
      c[k] = hn::Sub(hn::Mul(x[j], y[k]), hn::Mul(y[j], x[k]));
    }
    const VF area = hn::Add(hn::Add(hn::Mul(a[0], x[2]), hn::Mul(b[0], y[2])), hn::Mul(c[0], w[2]));
    const auto is_front = hn::Gt(area, zero);
    auto seen = hn::Gt(Max3(w), zero);
    for (int k = 0; k < 3; ++k) {
      const auto along = hn::Eq(a[k], zero);
      const VF slope = hn::IfThenZeroElse(along, hn::Neg(hn::Div(b[k], a[k])));
      const VF from = hn::Sub(hn::Neg(hn::Div(c[k], a[k])), hn::Set(d, 0.5F));
      const auto is_left = hn::Or(along, hn::Not(hn::Xor(hn::Gt(a[k], zero), is_front)));
      hn::Store(slope, d, block.slope[k] + at);
      hn::Store(hn::IfThenElse(along, hn::Neg(infinite), from), d, block.from[k] + at);
      hn::Store(hn::IfThenElse(is_left, infinite, hn::Neg(infinite)), d, block.side[k] + at);
      // Along the rows: rows from the cut on are inside, or before it, or all or none.
      const VF turned = hn::IfThenElse(is_front, b[k], hn::Neg(b[k]));
      const VF constant = hn::IfThenElse(is_front, c[k], hn::Neg(c[k]));
      const VI cut = FirstCentreFrom(d, hn::Neg(hn::Div(c[k], b[k])), view.height);
      const auto down = hn::RebindMask(di, hn::And(along, hn::Gt(turned, zero)));
      const auto up = hn::RebindMask(di, hn::And(along, hn::Lt(turned, zero)));
      y0 = hn::IfThenElse(down, hn::Max(y0, cut), y0);
      y1 = hn::IfThenElse(up, hn::Min(y1, cut), y1);
      const auto is_flat = hn::And(along, hn::Eq(turned, zero));
      seen = hn::And(seen, hn::Not(hn::And(is_flat, hn::Le(constant, zero))));
    }
    const std::uint32_t boxed = StoreBox(di, x0, x1, y0, y1, at, block);
    const auto drawn = static_cast<std::uint32_t>(HasArea(d, area) & MaskBits(d, seen));
    block.front |= static_cast<std::uint32_t>(MaskBits(d, is_front)) << at;
    block.drawn |= (boxed & drawn) << at;
  }
  FindSmall(block);
}

/// The spans of kLanes rows, or of a row of kLanes triangles.
struct HomogeneousRows {
  VI first, last;

  /// get(p) makes a vector of what is at p of each triangle of the block.
  template <class Get>
  HWY_INLINE HomogeneousRows(const HomogeneousBlock& block, VI x0, VI x1, VF y, const Get& get) {
    const DF d;
    const VF least = hn::ConvertTo(d, x0);
    const VF most = hn::ConvertTo(d, x1);
    VF from = least;
    VF to = most;
    for (int k = 0; k < 3; ++k) {
      const VF crossing = hn::Add(get(block.from[k]), hn::Mul(y, get(block.slope[k])));
      const VF column = hn::Min(hn::Max(hn::Ceil(crossing), least), most);
      const VF side = get(block.side[k]);
      from = hn::Max(from, hn::Min(column, side));
      to = hn::Min(to, hn::Max(column, side));
    }
    first = Truncated(from);
    last = Truncated(hn::Max(from, to));
  }
};

/// Fills in the masks of the small triangles, kLanes of them a row at a time.
inline HWY_NOINLINE void FindSmallHomogeneous(HomogeneousBlock& block) {
  const DF d;
  const DI di;
  for (int at = 0; at < kBlock; at += kLanes) {
    if (((block.small >> at) & ((std::uint64_t{1} << kLanes) - 1)) == 0) continue;
    const VI x0 = hn::Load(di, block.x0 + at);
    const VI x1 = hn::Min(hn::Load(di, block.x1 + at), hn::Add(x0, hn::Set(di, 8)));
    const VI y0 = hn::Load(di, block.y0 + at);
    const VI rows = hn::Sub(hn::Load(di, block.y1 + at), y0);
    const VF y = hn::Add(hn::ConvertTo(d, y0), hn::Set(d, 0.5F));
    VI halves[2] = {hn::Zero(di), hn::Zero(di)};
    for (int row = 0; row < block.height; ++row) {
      const HomogeneousRows crossed(block, x0, x1, hn::Add(y, hn::Set(d, static_cast<float>(row))),
                                    [&](const float* p) { return hn::Load(d, p + at); });
      const VI one = hn::Set(di, 1);
      const VI bits = hn::Sub(hn::Shl(one, hn::Sub(crossed.last, x0)),
                              hn::Shl(one, hn::Sub(crossed.first, x0)));
      const auto covered = hn::Gt(rows, hn::Set(di, row));
      VI& half = halves[row >> 2];
      half = hn::Or(half, hn::ShiftLeftSame(hn::IfThenElseZero(covered, bits), 8 * (row & 3)));
    }
    StoreMasks(halves, block.masks + at);
  }
}

/// Draws the rows of a triangle, kLanes at a time.
template <class Sink>
HWY_NOINLINE void DrawHomogeneousRows(const HomogeneousBlock& block, int i, Sink sink) {
  const DF d;
  const DI di;
  const Box box = block.BoxOf(i);
  const VI x0 = hn::Set(di, box.x0);
  const VI x1 = hn::Set(di, box.x1);
  for (int row = box.y0; row < box.y1; row += kLanes) {
    const HomogeneousRows crossed(block, x0, x1, FloatsFrom(d, static_cast<float>(row) + 0.5F),
                                  [&](const float* p) { return hn::Set(d, p[i]); });
    EmitRows(sink, box.x1 - box.x0, row, Least(kLanes, box.y1 - row), crossed.first, crossed.last);
  }
}

template <class Sink>
void DrawHomogeneous(const KernelView& view) {
  Sink sink(view);
  HomogeneousBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpHomogeneous(view, indices, block);
        if (block.small != 0) FindSmallHomogeneous(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          if (block.masks[i] != 0) sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
        } else {
          DrawHomogeneousRows(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_HOMOGENEOUS_H_
