// The kernel of clip space: triangles of (x, y, w), any sign of w, no division by it and nothing
// clipped.
//
// A sample is covered if the ray through it meets the triangle before the eye: if it is inside
// three edges N . (x, y, 1), N = V_j x V_i, by the facing (reference/homogeneous.h). What a row has
// inside an edge begins or ends where it crosses it, guessed as in exact_crossings.h; the near
// plane is one edge more of the triangles that it cuts. Most triangles lie before the eye: these
// are drawn as in window space, from projected corners (clip_floats.h) or in steps (exact_steps.h).
#ifndef RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_
#define RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/clip_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/exact_steps.h"
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

/// The same of a triangle that it does not cut.
inline HWY_NOINLINE void FindColumns(const KernelView& view, const ClipBlock& block, int i, int row,
                                     int rows, std::int32_t* first, std::int32_t* last) {
  ClipCrossings<3>(view, block, i).Find(view, block, i, row, rows, first, last);
}

template <class Sink>
HWY_INLINE void DrawClipTriangle(const KernelView& view, const ClipBlock& block, int i,
                                 std::uint32_t triangle, int first_row, Sink& sink) {
  const bool is_front = block.Has(block.front, i);
  int y0 = first_row;
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

/// Of a triangle before the eye, its corners' order by y and the rows of its edges.
struct SortedRows {
  int top = 0, middle = 1, bottom = 2;
  int first = 0, turn = 0, end = 0;  ///< rows of the long edge; the middle corner's

  /// Returns false where a corner lies too near to a row's centre to tell.
  HWY_INLINE bool Find(const ClipBlock& block, int i, int first_row) {
    const double y[3] = {block.row_of[0][i], block.row_of[1][i], block.row_of[2][i]};
    const auto sort = [&](int& a, int& b) {
      const bool swap = y[b] < y[a];
      const int first_one = swap ? b : a;
      b = swap ? a : b;
      a = first_one;
    };
    sort(top, middle);
    sort(middle, bottom);
    sort(top, middle);
    bool tells = true;
    const auto row = [&](int corner) {
      const double below = y[corner] - 0.5;
      const double above = __builtin_ceil(below);
      const double fraction = above - below;
      tells &= fraction > kClipRowRoom && fraction < 1 - kClipRowRoom;
      return Clamped(above, first_row, block.y1[i]);
    };
    first = row(top);
    turn = row(middle);
    end = row(bottom);
    return tells;
  }

 private:
  HWY_INLINE static int Clamped(double v, int least, int most) {
    return v <= least ? least : v >= most ? most : static_cast<int>(v);
  }
};

/// Draws a triangle from first_row on in steps of fixed point. Returns false, with nothing drawn,
/// where a corner's row, or an edge's guess in double, does not tell.
template <class Sink>
HWY_INLINE bool DrawClipSteps(const KernelView& view, const ClipBlock& block, int i,
                              std::uint32_t triangle, int first_row, Sink& sink) {
  const DI di;
  SortedRows rows;
  if (!rows.Find(block, i, first_row) || !(block.twice_error[i] <= 2 * kStepError)) return false;
  SteppedEdge whole, upper, lower;
  // Edge k + 1 is opposite corner k.
  const auto start = [&](SteppedEdge& edge, int opposite, int first, int end) {
    const int e = opposite == 2 ? 0 : opposite + 1;
    const double slope = block.slope[e][i];
    return edge.Start(slope, first, end, rows.first,
                      [&](double y) { return (y * slope + block.from[e][i]) + kStepError; });
  };
  if (!start(whole, rows.middle, rows.first, rows.end)) return false;
  if (!start(upper, rows.bottom, rows.first, rows.turn)) return false;
  if (!start(lower, rows.top, rows.turn, rows.end)) return false;
  const VI lane = hn::ConvertTo(di, FloatsFrom(DF(), 0));
  const VI columns = hn::Set(di, view.width);
  const int width = block.x1[i] - block.x0[i];
  sink.Begin(triangle, block.Has(block.front, i), block.PlaneOf(i));
  for (int row = rows.first; row < rows.end; row += kLanes) {
    const int count = Least(kLanes, rows.end - row);
    const std::uint64_t valid = (std::uint64_t{1} << count) - 1;
    const VI by_long = whole.Next();
    const auto is_upper = hn::Lt(lane, hn::Set(di, rows.turn - row));
    const VI by_upper = upper.Next();
    const VI by_short = hn::IfThenElse(is_upper, by_upper, lower.Next());
    const auto open = HasOpenFraction(LesserFractions(by_long, by_short), 2 * kClipStepError);
    if (HWY_UNLIKELY((MaskBits(di, open) & valid) != 0)) {
      alignas(64) std::int32_t first[kRowsAtOnce], last[kRowsAtOnce];
      FindColumns(view, block, i, row, count, first, last);
      Emit(sink, width, row, count, first, last);
      continue;
    }
    const auto column = [&](VI guess) {
      return hn::Max(hn::Min(hn::ShiftRight<kSmallBits>(guess), columns), hn::Zero(di));
    };
    const VI long_column = column(by_long);
    const VI short_column = column(by_short);
    EmitRows(sink, width, row, count, hn::Min(long_column, short_column),
             hn::Max(long_column, short_column));
  }
  return true;
}

/// Draws rows of a near triangle. Returns the first row that was not drawn, for a guess did not
/// tell, or the end of its box.
template <class Sink>
HWY_INLINE int DrawNearClip(const ClipBlock& block, int i, std::uint32_t triangle, Sink& sink) {
  const DF d;
  const VF error = hn::Set(d, 2 * kClipBoxCrossingError);
  const VF steepest = hn::Set(d, kClipFloatSlope);
  const auto decide = [&](int /*row*/, const SomeNearRows& some, std::uint64_t valid) {
    const VF fraction =
        hn::Min(hn::Sub(some.by_long, some.long_column), hn::Sub(some.by_short, some.short_column));
    const auto open = hn::Or(hn::Lt(fraction, error), hn::Gt(hn::Abs(some.short_slope), steepest));
    return (MaskBits(d, open) & valid) == 0;
  };
  return DrawNearRows(block.near_rows, i, block.BoxOf(i), block.PlaneOf(i), triangle,
                      kClipBoxCrossingError, sink, decide);
}

/// The edges of a triangle that float32 began, and of those beside it.
inline HWY_NOINLINE void SetUpEdges(const KernelView& view, int i, ClipBlock& block) {
  SetUpGroup<false>(view, 0, true, i / kDoubles * kDoubles, block);
}

/// Draws rows from `row` on of a triangle in double. A sink of its own: one that is passed on keeps
/// its state in memory.
template <class Sink>
HWY_NOINLINE void DrawInDouble(const KernelView& view, ClipBlock& block, int i,
                               std::uint32_t triangle, int row) {
  Sink sink(view);
  if (!block.Has(block.in_double, i)) SetUpEdges(view, i, block);
  const std::uint32_t searched = block.searched[0] | block.searched[1] | block.searched[2];
  const bool can_step = block.Has(block.stepped & ~(searched | block.cut), i) &&
                        Greatest(view.width, view.height) <= static_cast<int>(kSteppedSide);
  if (can_step && DrawClipSteps(view, block, i, triangle, row, sink)) return;
  DrawClipTriangle(view, block, i, triangle, row, sink);
}

template <class Sink>
void DrawClip(const KernelView& view) {
  Sink sink(view);
  ClipBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpClip<Sink::kNeedsPlane, Sink::kNeedsFacing>(view, indices, block);
      },
      [&](int i, std::uint32_t triangle) {
        if (block.Has(block.small, i)) {
          if (block.masks[i] == 0) return;
          sink.Begin(triangle, block.Has(block.front, i), block.PlaneOf(i));
          sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
          return;
        }
        int row = block.y0[i];
        if (block.Has(block.near, i)) {
          row = DrawNearClip(block, i, triangle, sink);
          if (HWY_LIKELY(row == block.y1[i])) return;
        }
        DrawInDouble<Sink>(view, block, i, triangle, row);
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_CLIP_ROWS_H_
