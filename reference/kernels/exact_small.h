// The exact kernel's small triangles: masks of 8x8 pixels, one triangle a lane.
#ifndef RASTERPROOF_REFERENCE_KERNELS_EXACT_SMALL_H_
#define RASTERPROOF_REFERENCE_KERNELS_EXACT_SMALL_H_

#include <cstddef>
#include <cstdint>

#include "reference/kernels/exact_block.h"
#include "reference/kernels/exact_crossings.h"
#include "reference/kernels/kernel_table.h"
#include "reference/kernels/vectors.h"

namespace rasterproof::reference::kernels::HWY_NAMESPACE {

/// Multiples of 1/256 of at most 9: differences have 12 bits, their products 24.
HWY_INLINE hn::Mask<DF> OnGrid(const ExactBlock& block, int at) {
  const DF d;
  const VF scale = hn::Set(d, 256.0F);
  auto on_grid = hn::Eq(scale, scale);
  for (int k = 0; k < 3; ++k) {
    const VF x = hn::Mul(hn::Load(d, block.sx[k] + at), scale);
    const VF y = hn::Mul(hn::Load(d, block.sy[k] + at), scale);
    on_grid = hn::And(on_grid, hn::And(hn::Eq(x, hn::Floor(x)), hn::Eq(y, hn::Floor(y))));
  }
  return on_grid;
}

/// Crossings of small triangles' edges in one row that the guess does not tell, decided.
/// `edge` has the edge of each lane: where `upper`, kUpperEdge, else `other`.
inline HWY_NOINLINE VF ResolveSmall(const KernelView& view, const ExactBlock& block, int at,
                                    int row, VF column, hn::Mask<DF> open, hn::Mask<DF> upper,
                                    bool is_long) {
  const DF d;
  const DD dd;
  const DDF df;
  alignas(64) float columns[kBlock];
  hn::Store(column, d, columns);
  const std::uint64_t open_bits = MaskBits(d, open);
  const std::uint64_t upper_bits = is_long ? 0 : MaskBits(d, upper);
  const auto load = [&](const float* p) { return hn::PromoteTo(dd, hn::Load(df, p)); };
  const VD y = hn::Set(dd, row + 0.5);
  for (int h = 0; h < kLanes; h += kDoubles) {
    const std::uint64_t bits = (open_bits >> h) & ((std::uint64_t{1} << kDoubles) - 1);
    if (bits == 0) continue;
    const MD first = MaskOf(dd, upper_bits >> h);
    const int from = at + h;
    const auto start = [&](const float(*p)[kBlock]) {
      return is_long ? load(p[0] + from)
                     : hn::IfThenElse(first, load(p[0] + from), load(p[1] + from));
    };
    const auto end = [&](const float(*p)[kBlock]) {
      return is_long ? load(p[2] + from)
                     : hn::IfThenElse(first, load(p[1] + from), load(p[2] + from));
    };
    const Edges edges{start(block.sx), start(block.sy), end(block.sx), end(block.sy)};
    const VD resolved = Resolve(view, load(columns + h), y, edges, MaskOf(dd, bits), [&](int lane) {
      const int i = from + lane;
      const bool is_upper = ((upper_bits >> (h + lane)) & 1) != 0;
      ExactEdge edge = block.EdgeOf(is_long ? kLongEdge : is_upper ? kUpperEdge : kLowerEdge, i);
      edge.left = block.x0[i];
      edge.top = block.y0[i];
      return edge;
    });
    hn::Store(hn::DemoteTo(df, resolved), df, columns + h);
  }
  return hn::Load(d, columns);
}

/// The edges of small triangles, one triangle a lane.
struct SmallEdges {
  VF from[2], y[3], slope[3];
  hn::Mask<DF> small;

  HWY_INLINE SmallEdges(const ExactBlock& block, int at) {
    const DF d;
    const VF offset = hn::Set(d, 0.5F + kSmallCrossingError);
    for (int k = 0; k < 2; ++k) from[k] = hn::Add(hn::Load(d, block.sx[k] + at), offset);
    for (int k = 0; k < 3; ++k) {
      y[k] = hn::Load(d, block.sy[k] + at);
      slope[k] = hn::Load(d, block.slope[k] + at);
    }
    small = MaskOf(d, block.small >> at);
  }
};

/// One row of them: guesses, and the columns that they round down to, 0 where there is no such row.
struct SmallRow {
  VF centre;
  hn::Mask<DF> covered, upper;
  VF by_long, by_short;
  VF long_column, short_column;

  HWY_INLINE SmallRow(const SmallEdges& e, int row) {
    const DF d;
    centre = hn::Set(d, static_cast<float>(row) + 0.5F);
    covered = hn::And(e.small, hn::And(hn::Ge(centre, e.y[0]), hn::Lt(centre, e.y[2])));
    upper = hn::Lt(centre, e.y[1]);
    by_long = hn::MulAdd(hn::Sub(centre, e.y[0]), e.slope[kLongEdge], e.from[0]);
    by_short = hn::MulAdd(hn::Sub(centre, hn::IfThenElse(upper, e.y[0], e.y[1])),
                          hn::IfThenElse(upper, e.slope[kUpperEdge], e.slope[kLowerEdge]),
                          hn::IfThenElse(upper, e.from[0], e.from[1]));
    long_column = hn::IfThenElseZero(covered, hn::Floor(by_long));
    short_column = hn::IfThenElseZero(covered, hn::Floor(by_short));
  }
};

/// Decides the rows of small triangles whose guesses do not tell: on a grid here, others elsewhere.
class SmallTies {
 public:
  HWY_INLINE SmallTies(const KernelView& view, const ExactBlock& block, int at)
      : view_(view), block_(block), at_(at), on_grid_(OnGrid(block, at)) {
    const DF d;
    for (int k = 0; k < 3; ++k) {
      x_[k] = hn::Load(d, block.sx[k] + at);
      y_[k] = hn::Load(d, block.sy[k] + at);
    }
    for (int e = 0; e < 3; ++e) {
      dx_[e] = hn::Sub(x_[kEndOf[e]], x_[kStartOf[e]]);
      dy_[e] = hn::Sub(y_[kEndOf[e]], y_[kStartOf[e]]);
    }
  }

  /// Corrects the columns. Returns whether some guess did not tell.
  HWY_INLINE bool Decide(int row, SmallRow& r) const {
    const DF d;
    const VF uncertain = hn::Set(d, 2 * kSmallCrossingError);
    const auto open = [&](VF guess, VF column) {
      return hn::And(r.covered, hn::Lt(hn::Sub(guess, column), uncertain));
    };
    const auto long_open = open(r.by_long, r.long_column);
    const auto short_open = open(r.by_short, r.short_column);
    const auto pick = [&](VF a, VF b) { return hn::IfThenElse(r.upper, a, b); };
    r.long_column =
        OnTheGrid(r, r.long_column, long_open, x_[0], y_[0], dx_[kLongEdge], dy_[kLongEdge]);
    r.short_column =
        OnTheGrid(r, r.short_column, short_open, pick(x_[0], x_[1]), pick(y_[0], y_[1]),
                  pick(dx_[kUpperEdge], dx_[kLowerEdge]), pick(dy_[kUpperEdge], dy_[kLowerEdge]));
    const auto long_left = hn::AndNot(on_grid_, long_open);
    const auto short_left = hn::AndNot(on_grid_, short_open);
    if (HWY_UNLIKELY(MaskBits(d, hn::Or(long_left, short_left)) != 0)) {
      r.long_column =
          ResolveSmall(view_, block_, at_, row, r.long_column, long_left, r.upper, true);
      r.short_column =
          ResolveSmall(view_, block_, at_, row, r.short_column, short_left, r.upper, false);
    }
    return MaskBits(d, hn::Or(long_open, short_open)) != 0;
  }

 private:
  /// Products of at most 24 bits: exact.
  HWY_INLINE VF OnTheGrid(const SmallRow& r, VF column, hn::Mask<DF> open, VF x, VF y, VF dx,
                          VF dy) const {
    const DF d;
    const VF a = hn::Sub(hn::Sub(column, hn::Set(d, 0.5F)), x);
    const auto is_right = hn::Ge(hn::Mul(a, dy), hn::Mul(hn::Sub(r.centre, y), dx));
    const auto before = hn::And(hn::And(open, on_grid_), is_right);
    return hn::IfThenElse(before, hn::Sub(column, hn::Set(d, 1.0F)), column);
  }

  const KernelView& view_;
  const ExactBlock& block_;
  int at_;
  hn::Mask<DF> on_grid_;
  VF x_[3], y_[3], dx_[3], dy_[3];
};

/// Rows of small triangles as bits of 8x8 masks, one triangle a lane.
class MaskRows {
 public:
  HWY_INLINE void Add(int row, const SmallRow& r) {
    const DI di;
    const VI one = hn::Set(di, 1);
    const VI first = hn::ConvertTo(di, hn::Min(r.long_column, r.short_column));
    const VI last = hn::ConvertTo(di, hn::Max(r.long_column, r.short_column));
    // A crossing in the last half pixel may be guessed one column too far.
    const VI bits = hn::And(hn::Sub(hn::Shl(one, last), hn::Shl(one, first)), hn::Set(di, 0xff));
    const int half = row >> 2;
    halves_[half] = hn::Or(halves_[half], hn::ShiftLeftSame(bits, 8 * (row & 3)));
  }

  HWY_INLINE void Store(std::uint64_t* masks) const {
    const DI di;
    alignas(64) std::int32_t low[kLanes], high[kLanes];
    hn::Store(halves_[0], di, low);
    hn::Store(halves_[1], di, high);
    for (int i = 0; i < kLanes; ++i) {
      masks[i] = std::uint64_t{static_cast<std::uint32_t>(low[i])} |
                 (std::uint64_t{static_cast<std::uint32_t>(high[i])} << 32);
    }
  }

 private:
  VI halves_[2] = {hn::Zero(DI()), hn::Zero(DI())};
};

/// Fills in the masks of small triangles of one group of lanes. Returns whether some row was not
/// told by its guess; with kResolve such rows are decided.
template <bool kExact, bool kResolve, bool kFacing>
HWY_NOINLINE bool FindExactMasks(const KernelView& view, ExactBlock& block, int at) {
  const DF d;
  const SmallEdges edges(block, at);
  const SmallTies ties(view, block, at);  // left out where nothing asks it
  VF least = hn::Set(d, 1.0F);
  bool any_open = false;
  MaskRows masks;
  auto long_is_left = hn::Lt(least, least);
  for (int row = 0; row < block.height; ++row) {
    SmallRow r(edges, row);
    if constexpr (kResolve) {
      any_open |= ties.Decide(row, r);
    } else if constexpr (kExact) {
      const VF fraction =
          hn::Min(hn::Sub(r.by_long, r.long_column), hn::Sub(r.by_short, r.short_column));
      least = hn::IfThenElse(r.covered, hn::Min(least, fraction), least);
    }
    if constexpr (kFacing) {
      long_is_left =
          hn::Or(long_is_left, hn::And(r.covered, hn::Lt(r.long_column, r.short_column)));
    }
    masks.Add(row, r);
  }
  masks.Store(block.masks + at);
  if constexpr (kFacing) {
    block.long_is_left |= static_cast<std::uint32_t>(MaskBits(d, long_is_left)) << at;
  }
  if constexpr (kExact && !kResolve) {
    any_open = MaskBits(d, hn::Lt(least, hn::Set(d, 2 * kSmallCrossingError))) != 0;
  }
  return any_open;
}

}  // namespace rasterproof::reference::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_REFERENCE_KERNELS_EXACT_SMALL_H_
