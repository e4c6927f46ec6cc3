// The exact kernel's small triangles: masks of 8x8 pixels, one triangle a lane.
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_SMALL_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_SMALL_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/exact_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

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
      const int e = is_long ? kLongEdge : is_upper ? kUpperEdge : kLowerEdge;
      const int a = kStartOf[e];
      const int c = kEndOf[e];
      return ExactEdge{block.sx[a][i], block.sy[a][i], block.sx[c][i], block.sy[c][i], 0, 0};
    });
    hn::Store(hn::DemoteTo(df, resolved), df, columns + h);
  }
  return hn::Load(d, columns);
}

HWY_INLINE void StoreMasks(const VI (&halves)[2], std::uint64_t* masks) {
  const DI di;
  alignas(64) std::int32_t low[kLanes], high[kLanes];
  hn::Store(halves[0], di, low);
  hn::Store(halves[1], di, high);
  for (int i = 0; i < kLanes; ++i) {
    masks[i] = std::uint64_t{static_cast<std::uint32_t>(low[i])} |
               (std::uint64_t{static_cast<std::uint32_t>(high[i])} << 32);
  }
}

/// The edges of small triangles, one triangle a lane: columns and slopes in units of kSmallUnit.
/// Either short edge begins at the middle corner, the upper one upwards.
struct SmallEdges {
  VF top, middle;
  VF from_top, from_middle;
  VF upper, lower, whole;  ///< slopes
  VF rows;

  HWY_INLINE explicit SmallEdges(const ExactGroup& g) {
    const DF d;
    const VF unit = hn::Set(d, kSmallUnit);
    const VF left = hn::Mul(g.x0, unit);
    VF x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::MulSub(g.c.x[k], unit, left);
      y[k] = hn::Sub(g.c.y[k], g.y0);
    }
    rows = hn::Sub(g.y1, g.y0);
    Join(x, y, kSmallCrossingError);
  }

  /// Of corners relative to the first pixel, of which a guess may be off by `error` columns.
  HWY_INLINE SmallEdges(const Corners<VF>& c, VF rows_, float error) : rows(rows_) {
    VF x[3];
    for (int k = 0; k < 3; ++k) x[k] = hn::Mul(c.x[k], hn::Set(DF(), kSmallUnit));
    Join(x, c.y, error);
  }

 private:
  HWY_INLINE void Join(const VF (&x)[3], const VF (&y)[3], float error) {
    const VF offset = hn::Set(DF(), (0.5F + error) * kSmallUnit);
    top = y[0];
    middle = y[1];
    from_top = hn::Add(x[0], offset);
    from_middle = hn::Add(x[1], offset);
    upper = hn::Div(hn::Sub(x[1], x[0]), hn::Sub(y[1], y[0]));
    lower = hn::Div(hn::Sub(x[2], x[1]), hn::Sub(y[2], y[1]));
    whole = hn::Div(hn::Sub(x[2], x[0]), hn::Sub(y[2], y[0]));
  }
};

/// One row of them: guesses in fixed point. Where a triangle has no such row, its last one again.
struct SmallRow {
  hn::Mask<DI> covered;
  VF below_top, below_middle;
  VF slope;  ///< of the short edge
  VI by_long, by_short;

  HWY_INLINE SmallRow(const SmallEdges& e, int row) {
    const DF d;
    const VF half = hn::Set(d, 0.5F);
    const VF first = hn::Set(d, static_cast<float>(row));
    covered = hn::RebindMask(DI(), hn::Gt(e.rows, first));
    const VF centre = hn::Min(hn::Add(first, half), hn::Sub(e.rows, half));
    below_top = hn::Sub(centre, e.top);
    below_middle = hn::Sub(centre, e.middle);
    slope = hn::IfNegativeThenElse(below_middle, e.upper, e.lower);
    by_long = Truncated(hn::MulAdd(below_top, e.whole, e.from_top));
    by_short = Truncated(hn::MulAdd(below_middle, slope, e.from_middle));
  }
};

/// Decides the rows of small triangles whose guesses do not tell: on a grid here, others elsewhere.
class SmallTies {
 public:
  HWY_INLINE SmallTies(const KernelView& view, const ExactBlock& block, int at)
      : view_(view), block_(block), at_(at), on_grid_(OnGrid(block, at)) {
    const DF d;
    small_ = MaskOf(DI(), block.small >> at);
    const auto load = [&](const float(*p)[kBlock], int k) { return hn::Load(d, p[k] + at); };
    for (int k = 0; k < 2; ++k) x_[k] = load(block.sx, k);
    for (int e = 0; e < 3; ++e) {
      dx_[e] = hn::Sub(load(block.sx, kEndOf[e]), load(block.sx, kStartOf[e]));
      dy_[e] = hn::Sub(load(block.sy, kEndOf[e]), load(block.sy, kStartOf[e]));
    }
  }

  /// Makes the columns of the guesses right. Returns whether some guess did not tell.
  HWY_INLINE bool Decide(int row, SmallRow& r) const {
    const DF d;
    const auto open = [&](VI guess) {
      return hn::RebindMask(
          d, hn::And(hn::And(small_, r.covered), HasOpenFraction(guess, 2 * kSmallCrossingError)));
    };
    const auto long_open = open(r.by_long);
    const auto short_open = open(r.by_short);
    const auto pick = [&](VF upper, VF lower) {
      return hn::IfNegativeThenElse(r.below_middle, upper, lower);
    };
    MoveBack(long_open, IsRight(r.by_long, x_[0], dx_[kLongEdge], dy_[kLongEdge], r.below_top),
             r.by_long);
    MoveBack(short_open,
             IsRight(r.by_short, x_[1], pick(dx_[kUpperEdge], dx_[kLowerEdge]),
                     pick(dy_[kUpperEdge], dy_[kLowerEdge]), r.below_middle),
             r.by_short);
    const auto any_open = hn::Or(long_open, short_open);
    if (HWY_UNLIKELY(MaskBits(d, hn::AndNot(on_grid_, any_open)) != 0)) {
      const auto resolve = [&](VI& guess, hn::Mask<DF> is_open, bool is_long) {
        const VF column = hn::ConvertTo(d, hn::ShiftRight<kSmallBits>(guess));
        const VF resolved =
            ResolveSmall(view_, block_, at_, row, column, hn::AndNot(on_grid_, is_open),
                         hn::Lt(r.below_middle, hn::Zero(d)), is_long);
        guess = hn::ShiftLeft<kSmallBits>(Truncated(resolved));
      };
      resolve(r.by_long, long_open, true);
      resolve(r.by_short, short_open, false);
    }
    return MaskBits(d, any_open) != 0;
  }

 private:
  /// Whether the last centre before the guess is at or right of the edge through (x, centre -
  /// below). Products of at most 24 bits: exact on the grid.
  HWY_INLINE hn::Mask<DF> IsRight(VI guess, VF x, VF dx, VF dy, VF below) const {
    const DF d;
    const VF column = hn::ConvertTo(d, hn::ShiftRight<kSmallBits>(guess));
    const VF a = hn::Sub(hn::Sub(column, hn::Set(d, 0.5F)), x);
    return hn::Ge(hn::Mul(a, dy), hn::Mul(below, dx));
  }
  /// By a column where the guess is open and the triangle on the grid.
  HWY_INLINE void MoveBack(hn::Mask<DF> open, hn::Mask<DF> is_right, VI& guess) const {
    const DI di;
    const auto before = hn::RebindMask(di, hn::And(hn::And(open, on_grid_), is_right));
    guess = hn::Sub(guess, hn::IfThenElseZero(before, hn::Set(di, 1 << kSmallBits)));
  }

  const KernelView& view_;
  const ExactBlock& block_;
  int at_;
  hn::Mask<DF> on_grid_;
  hn::Mask<DI> small_;
  VF x_[2], dx_[3], dy_[3];
};

/// The pixels of a row: bits of byte `row` of a half.
HWY_INLINE VI BitsOfRow(int row, const SmallRow& r) {
  const DI di;
  const VI one = hn::Set(di, 1 << (8 * row));
  const VI first = hn::ShiftRight<kSmallBits>(hn::Min(r.by_long, r.by_short));
  const VI last = hn::ShiftRight<kSmallBits>(hn::Max(r.by_long, r.by_short));
  // A crossing in the last half pixel may be guessed one column too far.
  const VI byte = hn::Set(di, static_cast<std::int32_t>(0xffU << (8 * row)));
  const VI bits = hn::And(hn::Sub(hn::Shl(one, last), hn::Shl(one, first)), byte);
  return hn::IfThenElseZero(r.covered, bits);
}

/// The masks of small triangles of one group of lanes, found row by row; with kResolve rows that
/// their guesses do not tell are decided.
template <bool kExact, bool kResolve, bool kFacing>
class SmallMasks {
 public:
  HWY_INLINE SmallMasks(const KernelView& view, const SmallEdges& edges, ExactBlock& block, int at)
      : edges_(edges), ties_(view, block, at), block_(block), at_(at) {}

  HWY_INLINE void Add(int row) {
    SmallRow r(edges_, row);
    if constexpr (kResolve) {
      any_open_ |= ties_.Decide(row, r);
    } else if constexpr (kExact) {
      least_ = LesserFractions(least_, LesserFractions(r.by_long, r.by_short));
    }
    if constexpr (kFacing) {
      const auto is_left =
          hn::Lt(hn::ShiftRight<kSmallBits>(r.by_long), hn::ShiftRight<kSmallBits>(r.by_short));
      long_is_left_ = hn::Or(long_is_left_, hn::And(r.covered, is_left));
    }
    VI& half = halves_[row >> 2];
    half = hn::Or(half, BitsOfRow(row & 3, r));
  }

  /// Whether some row was not told by its guess.
  HWY_INLINE bool Store() const {
    const DI di;
    const std::uint64_t small = (block_.small >> at_) & ((std::uint64_t{1} << kLanes) - 1);
    StoreMasks(halves_, block_.masks + at_);
    if constexpr (kFacing) {
      block_.long_is_left |= static_cast<std::uint32_t>(MaskBits(di, long_is_left_)) << at_;
    }
    if constexpr (kResolve) return any_open_;
    if constexpr (!kExact) return false;
    return (MaskBits(di, HasOpenFraction(least_, 2 * kSmallCrossingError)) & small) != 0;
  }

 private:
  const SmallEdges& edges_;
  const SmallTies ties_;  // left out where nothing asks it
  ExactBlock& block_;
  int at_;
  bool any_open_ = false;
  VI least_ = hn::Set(DI(), kSmallFraction);  // fractions
  VI halves_[2] = {hn::Zero(DI()), hn::Zero(DI())};
  hn::Mask<DI> long_is_left_ = hn::Lt(halves_[0], halves_[0]);
};

/// Fills in the masks of small triangles of one group of lanes. Returns whether some row was not
/// told by its guess.
template <bool kExact, bool kResolve, bool kFacing>
HWY_INLINE bool FindExactMasks(const KernelView& view, const SmallEdges& edges, ExactBlock& block,
                               int at) {
  const DF d;
  const std::uint64_t small = (block.small >> at) & ((std::uint64_t{1} << kLanes) - 1);
  const auto any_taller = [&](int rows) {
    return (MaskBits(d, hn::Gt(edges.rows, hn::Set(d, static_cast<float>(rows)))) & small) != 0;
  };
  SmallMasks<kExact, kResolve, kFacing> masks(view, edges, block, at);
  masks.Add(0);
  masks.Add(1);
  masks.Add(2);
  masks.Add(3);
  if (any_taller(4)) {
    masks.Add(4);
    masks.Add(5);
    masks.Add(6);
    masks.Add(7);
  }
  return masks.Store();
}

/// The same where some row is not told by its guess.
template <bool kFacing>
HWY_NOINLINE bool ResolveMasks(const KernelView& view, const ExactGroup& g, const SmallEdges& edges,
                               ExactBlock& block, int at) {
  StoreRelative(g.c, g.x0, g.y0, at, block);
  return FindExactMasks<true, true, kFacing>(view, edges, block, at);
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_SMALL_H_
