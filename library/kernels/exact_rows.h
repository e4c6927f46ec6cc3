// The exact kernel's rows: those of one triangle, one a lane.
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_ROWS_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_ROWS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Crossings of a near triangle with rows from `row` on, one a lane, that the guess does not tell.
/// The edge is kUpperEdge in the lanes of `upper`, else kLowerEdge; kLongEdge if is_long.
inline HWY_NOINLINE VF ResolveNear(const KernelView& view, const ExactBlock& block, int i, int row,
                                   VF column, std::uint64_t open_bits, std::uint64_t upper_bits,
                                   bool is_long) {
  const DF d;
  const DD dd;
  const DDF df;
  const auto at = [&](int lane) {
    const bool is_upper = ((upper_bits >> lane) & 1) != 0;
    ExactEdge edge = block.EdgeOf(is_long ? kLongEdge : is_upper ? kUpperEdge : kLowerEdge, i);
    edge.left = block.x0[i];
    edge.top = block.y0[i];
    return edge;
  };
  alignas(64) float columns[kLanes];
  hn::Store(column, d, columns);
  if (AreFew(open_bits)) {
    const std::uint64_t too_many = OneTooMany(view, columns, row, open_bits, at);
    return hn::Sub(column, hn::IfThenElseZero(MaskOf(d, too_many), hn::Set(d, 1.0F)));
  }
  for (int h = 0; h < kLanes; h += kDoubles) {
    const std::uint64_t bits = (open_bits >> h) & ((std::uint64_t{1} << kDoubles) - 1);
    if (bits == 0) continue;
    const MD first = MaskOf(dd, upper_bits >> h);
    const auto pick = [&](const float(*p)[kBlock], int upper, int lower, int both) {
      const VD of_both = hn::Set(dd, static_cast<double>(p[both][i]));
      const VD of_upper = hn::Set(dd, static_cast<double>(p[upper][i]));
      const VD of_lower = hn::Set(dd, static_cast<double>(p[lower][i]));
      return is_long ? of_both : hn::IfThenElse(first, of_upper, of_lower);
    };
    const Edges edges{pick(block.sx, 0, 1, 0), pick(block.sy, 0, 1, 0), pick(block.sx, 1, 2, 2),
                      pick(block.sy, 1, 2, 2)};
    const VD resolved =
        Resolve(view, hn::PromoteTo(dd, hn::Load(df, columns + h)), DoublesFrom(row + h + 0.5),
                edges, MaskOf(dd, bits), [&](int lane) { return at(h + lane); });
    hn::Store(hn::DemoteTo(df, resolved), df, columns + h);
  }
  return hn::Load(d, columns);
}

/// Calls sink for rows from `row` on, whose spans are [first, last) of each; at most 64.
template <class Sink>
HWY_INLINE void Emit(Sink& sink, int width, int row, int rows, const std::int32_t* first,
                     const std::int32_t* last) {
  if (width <= 16) {
    for (int r = 0; r < rows; ++r) {
      sink.template ShortSpan<16>(row + r, first[r], last[r] - first[r]);
    }
  } else if (width <= 32) {
    for (int r = 0; r < rows; ++r) {
      sink.template ShortSpan<32>(row + r, first[r], last[r] - first[r]);
    }
  } else if (width <= 64) {
    for (int r = 0; r < rows; ++r) {
      sink.template ShortSpan<64>(row + r, first[r], last[r] - first[r]);
    }
  } else {
    // Most rows of a sliver are empty: no branch for each of them.
    std::uint64_t covered = 0;
    for (int at = 0; at < rows; at += kLanes) {
      const DI di;
      const auto is_covered = hn::Lt(hn::Load(di, first + at), hn::Load(di, last + at));
      covered |= MaskBits(di, is_covered) << at;
    }
    covered &= ~std::uint64_t{0} >> (64 - rows);
    for (; covered != 0; covered &= covered - 1) {
      const int r = CountTrailingZeros(covered);
      sink.Span(row + r, first[r], last[r]);
    }
  }
}

/// The same of the rows of one vector.
template <class Sink>
HWY_INLINE void EmitRows(Sink& sink, int width, int row, int rows, VI first, VI last) {
  if constexpr (Sink::kTakesRows) {
    if (sink.ShortRows(row, rows, first, last)) return;
  }
  const DI di;
  alignas(64) std::int32_t from[kLanes], to[kLanes];
  hn::Store(first, di, from);
  hn::Store(last, di, to);
  Emit(sink, width, row, rows, from, to);
}

/// Rows of a near triangle as they cross its edges.
struct NearRows {
  VF from0, from1, top, middle;
  VF long_slope, upper_slope, lower_slope;

  HWY_INLINE NearRows(const NearBlock& block, int i, float error) {
    const DF d;
    from0 = hn::Set(d, block.sx[0][i] + (0.5F + error));
    from1 = hn::Set(d, block.sx[1][i] + (0.5F + error));
    top = hn::Set(d, block.sy[0][i]);
    middle = hn::Set(d, block.sy[1][i]);
    long_slope = hn::Set(d, block.slope[kLongEdge][i]);
    upper_slope = hn::Set(d, block.slope[kUpperEdge][i]);
    lower_slope = hn::Set(d, block.slope[kLowerEdge][i]);
  }
};

/// kLanes of them, from `row` of the box on.
struct SomeNearRows {
  hn::Mask<DF> upper;  ///< above the middle corner
  VF short_slope;
  VF by_long, by_short;
  VF long_column, short_column;

  HWY_INLINE SomeNearRows(const NearRows& rows, int row) {
    const VF centre = FloatsFrom(DF(), static_cast<float>(row) + 0.5F);
    upper = hn::Lt(centre, rows.middle);
    short_slope = hn::IfThenElse(upper, rows.upper_slope, rows.lower_slope);
    by_long = hn::MulAdd(hn::Sub(centre, rows.top), rows.long_slope, rows.from0);
    by_short = hn::MulAdd(hn::Sub(centre, hn::IfThenElse(upper, rows.top, rows.middle)),
                          short_slope, hn::IfThenElse(upper, rows.from0, rows.from1));
    long_column = hn::Floor(by_long);
    short_column = hn::Floor(by_short);
  }
};

/// Draws rows of a near triangle, kLanes at a time. decide(row, rows, valid) sees to guesses that
/// do not tell, of the rows that are bits of `valid`; false ends the drawing. Returns the first row
/// that was not drawn.
template <class Sink, class P, class Decide>
HWY_INLINE int DrawNearRows(const NearBlock& block, int i, const Box& box, const P& plane,
                            std::uint32_t triangle, float error, Sink& sink, const Decide& decide) {
  const DF d;
  const DI di;
  const NearRows near(block, i, error);
  const VI left = hn::Set(di, box.x0);
  bool has_begun = !Sink::kNeedsFacing;
  if (has_begun) sink.Begin(triangle, false, plane);
  for (int row = box.y0; row < box.y1; row += kLanes) {
    const int rows = Least(kLanes, box.y1 - row);
    const std::uint64_t valid = (std::uint64_t{1} << rows) - 1;
    SomeNearRows some(near, row - box.y0);
    if (!decide(row - box.y0, some, valid)) return row;
    if constexpr (Sink::kNeedsFacing) {
      if (!has_begun) {
        const std::uint64_t differ =
            valid & ~MaskBits(d, hn::Eq(some.long_column, some.short_column));
        if (differ == 0) continue;
        const std::uint64_t is_left =
            differ & MaskBits(d, hn::Lt(some.long_column, some.short_column));
        sink.Begin(triangle, IsFrontBy(is_left != 0, ((block.odd >> i) & 1) != 0), plane);
        has_begun = true;
      }
    }
    EmitRows(sink, box.x1 - box.x0, row, rows,
             hn::Add(Truncated(hn::Min(some.long_column, some.short_column)), left),
             hn::Add(Truncated(hn::Max(some.long_column, some.short_column)), left));
  }
  return box.y1;
}

/// The same in window space.
template <bool kExact, class Sink>
HWY_INLINE void DrawNear(const KernelView& view, const ExactBlock& block, int i,
                         std::uint32_t triangle, Sink& sink) {
  const DF d;
  const VF error = hn::Set(d, 2 * kNearCrossingError);
  const auto decide = [&](int row, SomeNearRows& some, std::uint64_t valid) {
    if constexpr (kExact) {
      const auto long_open = hn::Lt(hn::Sub(some.by_long, some.long_column), error);
      const auto short_open = hn::Lt(hn::Sub(some.by_short, some.short_column), error);
      if (HWY_UNLIKELY((MaskBits(d, hn::Or(long_open, short_open)) & valid) != 0)) {
        const std::uint64_t upper_bits = MaskBits(d, some.upper);
        const auto resolve = [&](VF& column, std::uint64_t open, bool is_long) {
          if (open == 0) return;
          column = ResolveNear(view, block, i, row, column, open, upper_bits, is_long);
        };
        resolve(some.long_column, MaskBits(d, long_open) & valid, true);
        resolve(some.short_column, MaskBits(d, short_open) & valid, false);
      }
    }
    return true;
  };
  DrawNearRows(block, i, block.BoxOf(i), block.PlaneOf(i), triangle, kNearCrossingError, sink,
               decide);
}

/// One edge of a triangle as rows cross it, or in each lane one of its short ones.
struct Crossing {
  VD from, top, slope;

  /// The crossing's x, and what makes it round down to the column behind it.
  HWY_INLINE VD At(VD centre) const { return hn::MulAdd(hn::Sub(centre, top), slope, from); }
};

HWY_INLINE Crossing CrossingOf(const ExactBlock& block, int edge, int i) {
  const DD dd;
  const int start = kStartOf[edge];
  return {hn::Set(dd, block.x[start][i] + (0.5 + kCrossingError)),
          hn::Set(dd, static_cast<double>(block.y[start][i])),
          hn::Set(dd, block.long_slope[edge][i])};
}

HWY_INLINE Crossing Choose(MD first, const Crossing& a, const Crossing& b) {
  return {hn::IfThenElse(first, a.from, b.from), hn::IfThenElse(first, a.top, b.top),
          hn::IfThenElse(first, a.slope, b.slope)};
}

/// Columns of rows from `row` on that the guess does not tell, decided. `open` are such rows; the
/// edge is kLongEdge if is_long, else kUpperEdge in the lanes of `upper`, else kLowerEdge.
inline HWY_NOINLINE VD ResolveRows(const KernelView& view, const ExactBlock& block, int i,
                                   VD column, VD centre, std::uint64_t open, std::uint64_t upper,
                                   bool is_long) {
  const DD dd;
  const MD first = MaskOf(dd, upper);
  const auto pick = [&](const float(*p)[kBlock], int of_upper, int of_lower, int of_long) {
    if (is_long) return hn::Set(dd, static_cast<double>(p[of_long][i]));
    return hn::IfThenElse(first, hn::Set(dd, static_cast<double>(p[of_upper][i])),
                          hn::Set(dd, static_cast<double>(p[of_lower][i])));
  };
  const Edges edges{pick(block.x, 0, 1, 0), pick(block.y, 0, 1, 0), pick(block.x, 1, 2, 2),
                    pick(block.y, 1, 2, 2)};
  return Resolve(view, column, centre, edges, MaskOf(dd, open), [&](int lane) {
    const bool is_upper = ((upper >> lane) & 1) != 0;
    return block.EdgeOf(is_long ? kLongEdge : is_upper ? kUpperEdge : kLowerEdge, i);
  });
}

/// Rows that are found before they are drawn.
constexpr int kRowsAtOnce = 16;

/// Rows of a triangle that is not near, kRowsAtOnce at a time. kInside: no span leaves the target.
template <bool kExact, bool kInside, class Sink>
HWY_INLINE void DrawExactRows(const KernelView& view, const ExactBlock& block, int i,
                              std::uint32_t triangle, Sink& sink) {
  const DD dd;
  const DDI di;
  const Box box = block.BoxOf(i);
  const VD error = hn::Set(dd, 2 * kCrossingError);
  const VD columns = hn::Set(dd, static_cast<double>(view.width));
  const VD middle = hn::Set(dd, static_cast<double>(block.y[1][i]));
  const Crossing long_edge = CrossingOf(block, kLongEdge, i);
  const Crossing upper_edge = CrossingOf(block, kUpperEdge, i);
  const Crossing lower_edge = CrossingOf(block, kLowerEdge, i);
  Crossing short_edge = upper_edge;
  const int width = box.x1 - box.x0;
  bool has_begun = !Sink::kNeedsFacing;
  if (has_begun) sink.Begin(triangle, false, block.PlaneOf(i));
  alignas(64) std::int32_t first[kRowsAtOnce], last[kRowsAtOnce];
  for (int row = box.y0; row < box.y1; row += kRowsAtOnce) {
    const int rows = Least(kRowsAtOnce, box.y1 - row);
    for (int at = 0; at < rows; at += kDoubles) {
      const VD centre = DoublesFrom(row + at + 0.5);
      if (row + at + kDoubles > block.middle_row[i]) {
        short_edge = Choose(hn::Lt(centre, middle), upper_edge, lower_edge);
      }
      const VD by_long = long_edge.At(centre);
      const VD by_short = short_edge.At(centre);
      VD long_column = hn::Floor(by_long);
      VD short_column = hn::Floor(by_short);
      const std::uint64_t valid = (std::uint64_t{1} << Least(kDoubles, rows - at)) - 1;
      if constexpr (kExact) {
        const MD long_open = hn::Lt(hn::Sub(by_long, long_column), error);
        const MD short_open = hn::Lt(hn::Sub(by_short, short_column), error);
        if (HWY_UNLIKELY((MaskBits(dd, hn::Or(long_open, short_open)) & valid) != 0)) {
          const std::uint64_t upper = MaskBits(dd, hn::Lt(centre, middle));
          long_column = ResolveRows(view, block, i, long_column, centre,
                                    MaskBits(dd, long_open) & valid, upper, true);
          short_column = ResolveRows(view, block, i, short_column, centre,
                                     MaskBits(dd, short_open) & valid, upper, false);
        }
      }
      if constexpr (Sink::kNeedsFacing) {
        const std::uint64_t differ = valid & ~MaskBits(dd, hn::Eq(long_column, short_column));
        if (!has_begun && differ != 0) {
          const std::uint64_t left = differ & MaskBits(dd, hn::Lt(long_column, short_column));
          sink.Begin(triangle, IsFrontBy(left != 0, ((block.odd >> i) & 1) != 0), block.PlaneOf(i));
          has_begun = true;
        }
      }
      const auto whole = [&](VD column) {
        if constexpr (!kInside) column = hn::Max(hn::Min(column, columns), hn::Zero(dd));
        return hn::DemoteTo(di, column);
      };
      hn::Store(whole(hn::Min(long_column, short_column)), di, first + at);
      hn::Store(whole(hn::Max(long_column, short_column)), di, last + at);
    }
    if (Sink::kNeedsFacing && !has_begun) continue;  // nothing is covered so far
    Emit(sink, width, row, rows, first, last);
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_ROWS_H_
