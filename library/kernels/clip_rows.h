// The kernel of clip space: triangles of (x, y, w), any sign of w, no division by it and nothing
// clipped.
//
// A sample is covered if the ray through it meets the triangle before the eye: if it is inside
// three edges N . (x, y, 1), N = V_j x V_i, by the facing (reference/homogeneous.h). What a row has
// inside an edge begins or ends where it crosses it, guessed as in exact_crossings.h; the near
// plane is one edge more of the triangles that it cuts.
#ifndef RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_
#define RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/clip_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Columns of rows from `row` on that a guess does not tell, decided: `column` or the one before.
inline HWY_NOINLINE VD ResolveClip(const KernelView& view, const ClipBlock& block, int i, int edge,
                                   int row, VD column, std::uint64_t open) {
  const DD dd;
  const ClipTriangle t = block.TriangleOf(view, i);
  const int facing = block.Has(block.front, i) ? 1 : -1;
  const bool is_left = block.side[edge][i] > 0;
  alignas(64) double columns[kDoubles];
  hn::Store(column, dd, columns);
  for (; open != 0; open &= open - 1) {
    const int lane = CountTrailingZeros(open);
    const double x = columns[lane] - 0.5;
    if (IsInsideClipEdge(t, edge, facing, x, row + lane + 0.5) == is_left) columns[lane] -= 1;
  }
  return hn::Load(dd, columns);
}

/// Cuts rows from `row` on by the edges that have no guess, each row searched exactly.
inline HWY_NOINLINE void CutExactly(const KernelView& view, const ClipBlock& block, int i, int row,
                                    int rows, std::int32_t* first, std::int32_t* last) {
  const ClipTriangle t = block.TriangleOf(view, i);
  const int facing = block.Has(block.front, i) ? 1 : -1;
  for (int e = 0; e <= kNearEdge; ++e) {
    if (!block.Has(block.searched[e], i)) continue;
    for (int r = 0; r < rows; ++r) {
      if (first[r] < last[r]) ClipColumns(t, e, facing, row + r, first[r], last[r]);
    }
  }
}

/// Where rows cross the edges of a triangle, kNearEdge among four.
template <int kEdges>
class ClipCrossings {
 public:
  HWY_INLINE ClipCrossings(const KernelView& view, const ClipBlock& block, int i) {
    const DD dd;
    for (int e = 0; e < kEdges; ++e) {
      slope_[e] = hn::Set(dd, block.slope[e][i]);
      from_[e] = hn::Set(dd, block.from[e][i]);
      side_[e] = hn::Set(dd, block.side[e][i]);
    }
    begin_ = hn::Set(dd, static_cast<double>(block.x0[i]));
    end_ = hn::Set(dd, static_cast<double>(block.x1[i]));
    most_ = hn::Set(dd, view.width + 1.5);
    twice_error_ = hn::Set(dd, block.twice_error[i]);
  }

  /// Columns [first, last) of `rows` rows from `row` on. Written are whole vectors.
  HWY_INLINE void Find(const KernelView& view, const ClipBlock& block, int i, int row, int rows,
                       std::int32_t* first, std::int32_t* last) const {
    for (int at = 0; at < rows; at += kDoubles) {
      const std::uint64_t valid = (std::uint64_t{1} << Least(kDoubles, rows - at)) - 1;
      VDI from_column, to_column;
      FindSome(view, block, i, row + at, valid, from_column, to_column);
      hn::Store(from_column, DDI(), first + at);
      hn::Store(to_column, DDI(), last + at);
    }
  }

 private:
  /// Of kDoubles rows, of which `valid` are asked for.
  HWY_INLINE void FindSome(const KernelView& view, const ClipBlock& block, int i, int row,
                           std::uint64_t valid, VDI& first, VDI& last) const {
    const DD dd;
    const DDI di;
    const VD y = DoublesFrom(row + 0.5);
    // Beyond these a guess tells, as their fractions do.
    const VD least = hn::Set(dd, -1.5);
    VD guess[kEdges], column[kEdges];
    for (int e = 0; e < kEdges; ++e) {
      guess[e] = hn::Min(hn::Max(hn::MulAdd(y, slope_[e], from_[e]), least), most_);
      column[e] = hn::Floor(guess[e]);
      guess[e] = hn::Sub(guess[e], column[e]);
    }
    VD fraction = guess[0];
    for (int e = 1; e < kEdges; ++e) fraction = hn::Min(fraction, guess[e]);
    if (HWY_UNLIKELY((MaskBits(dd, hn::Lt(fraction, twice_error_)) & valid) != 0)) {
      for (int e = 0; e < kEdges; ++e) {
        const std::uint64_t open = MaskBits(dd, hn::Lt(guess[e], twice_error_)) & valid;
        if (open != 0) column[e] = ResolveClip(view, block, i, e, row, column[e], open);
      }
    }
    VD from_column = begin_;
    VD to_column = end_;
    for (int e = 0; e < kEdges; ++e) {  // by sides of infinity, without a branch
      from_column = hn::Max(from_column, hn::Min(column[e], side_[e]));
      to_column = hn::Min(to_column, hn::Max(column[e], side_[e]));
    }
    first = hn::DemoteTo(di, from_column);
    last = hn::DemoteTo(di, hn::Max(from_column, to_column));
  }

  VD slope_[kEdges], from_[kEdges], side_[kEdges];
  VD begin_, end_, most_, twice_error_;
};

/// The columns of a triangle that the near plane cuts.
inline HWY_NOINLINE void FindCutColumns(const KernelView& view, const ClipBlock& block, int i,
                                        int row, int rows, std::int32_t* first,
                                        std::int32_t* last) {
  ClipCrossings<4>(view, block, i).Find(view, block, i, row, rows, first, last);
}

template <class Sink>
HWY_INLINE void DrawClipTriangle(const KernelView& view, const ClipBlock& block, int i,
                                 std::uint32_t triangle, Sink& sink) {
  const bool is_front = block.Has(block.front, i);
  int y0 = block.y0[i];
  int y1 = block.y1[i];
  if (HWY_UNLIKELY(block.Has(block.parallel[0] | block.parallel[1] | block.parallel[2], i))) {
    for (int e = 0; e < 3; ++e) {
      if (!block.Has(block.parallel[e], i)) continue;
      ClipRows(block.TriangleOf(view, i), e, is_front ? 1 : -1, y0, y1);
    }
  }
  const std::uint32_t searched = block.searched[0] | block.searched[1] | block.searched[2];
  const bool has_exact = block.Has(searched | block.searched[kNearEdge], i);
  const bool is_cut = block.Has(block.cut, i);
  const ClipCrossings<3> crossings(view, block, i);
  sink.Begin(triangle, is_front, block.PlaneOf(i));
  alignas(64) std::int32_t first[kRowsAtOnce], last[kRowsAtOnce];
  for (int row = y0; row < y1; row += kRowsAtOnce) {
    const int rows = Least(kRowsAtOnce, y1 - row);
    if (HWY_UNLIKELY(is_cut)) {
      FindCutColumns(view, block, i, row, rows, first, last);
    } else {
      crossings.Find(view, block, i, row, rows, first, last);
    }
    if (HWY_UNLIKELY(has_exact)) CutExactly(view, block, i, row, rows, first, last);
    Emit(sink, block.x1[i] - block.x0[i], row, rows, first, last);
  }
}

template <class Sink>
void DrawClip(const KernelView& view) {
  Sink sink(view);
  ClipBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) { SetUpClip<Sink::kNeedsPlane>(view, indices, block); },
      [&](int i, std::uint32_t triangle) {
        if (!block.Has(block.small, i)) {
          DrawClipTriangle(view, block, i, triangle, sink);
        } else if (block.masks[i] != 0) {
          sink.Begin(triangle, block.Has(block.front, i), block.PlaneOf(i));
          sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_
