// Where an edge crosses a row of pixel centres: guessed, and decided exactly where the guess does
// not tell.
//
// The crossing of an edge (a, c), a.y < c.y, with the row at height y, a.y <= y < c.y, is the first
// column whose centre is at or right of the edge. A triangle's row is the half-open span between
// the crossings of its two edges there: the top-left rule for either winding, without an
// orientation test (library/row_crossing.h).
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_CROSSINGS_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_CROSSINGS_H_

#include <cmath>
#include <cstdint>

#include "library/kernels/crossing_errors.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

using MD = hn::Mask<DD>;

/// first, first + 1, ... exact.
alignas(64) constexpr double kFirstDoubles[8] = {0, 1, 2, 3, 4, 5, 6, 7};
HWY_INLINE VD DoublesFrom(double first) {
  const DD dd;
  return hn::Add(hn::Set(dd, first), hn::Load(dd, kFirstDoubles));
}

// Guesses in fixed point: of kSmallUnit a column.
constexpr int kSmallBits = 16;  ///< kSmallUnit is 2^kSmallBits
constexpr std::int32_t kSmallFraction = (1 << kSmallBits) - 1;

/// Where the fraction of a guess is below what tells.
HWY_INLINE hn::Mask<DI> HasOpenFraction(VI guess, float below) {
  const DI di;
  const VI fraction = hn::And(guess, hn::Set(di, kSmallFraction));
  return hn::Lt(fraction, hn::Set(di, static_cast<std::int32_t>(below * kSmallUnit)));
}

/// Numbers with the lesser fraction of both; their columns are of no use.
HWY_INLINE VI LesserFractions(VI a, VI b) {
  const DI di;
#if HWY_TARGET == HWY_SCALAR
  const VI fraction = hn::Set(di, kSmallFraction);
  return hn::Min(hn::And(a, fraction), hn::And(b, fraction));
#else
  const hn::Repartition<std::uint16_t, DI> halves;
  return hn::BitCast(di, hn::Min(hn::BitCast(halves, a), hn::BitCast(halves, b)));
#endif
}

/// u - v and what rounding took from it: their sum is exact.
HWY_INLINE VD DifferenceError(VD u, VD v, VD difference) {
  const VD v_seen = hn::Sub(u, difference);
  const VD u_seen = hn::Add(difference, v_seen);
  return hn::Add(hn::Sub(u, u_seen), hn::Sub(v_seen, v));
}

/// a b - product, product = a b rounded.
///
/// Domain:     no underflow or overflow: differences of float32 values and pixel centres.
HWY_INLINE VD ProductError(VD a, VD b, VD product) {
#if HWY_NATIVE_FMA
  return hn::MulSub(a, b, product);
#else
  // Dekker 1971: halves of 26 bits, whose products are exact.
  const DD dd;
  const VD splitter = hn::Set(dd, 0x1p27 + 1);
  const VD a_scaled = hn::Mul(splitter, a);
  const VD a_high = hn::Sub(a_scaled, hn::Sub(a_scaled, a));
  const VD a_low = hn::Sub(a, a_high);
  const VD b_scaled = hn::Mul(splitter, b);
  const VD b_high = hn::Sub(b_scaled, hn::Sub(b_scaled, b));
  const VD b_low = hn::Sub(b, b_high);
  const VD high = hn::Sub(hn::Mul(a_high, b_high), product);
  const VD middle = hn::Add(hn::Add(high, hn::Mul(a_high, b_low)), hn::Mul(a_low, b_high));
  return hn::Add(middle, hn::Mul(a_low, b_low));
#endif
}

/// An edge in each lane, from its upper end a to its lower end c.
struct Edges {
  VD ax, ay, cx, cy;
};

/// Lanes where the centre (x, y) is at or right of the edge; `decided` are those where that is
/// proved: (x - a.x)(c.y - a.y) >= (y - a.y)(c.x - a.x) with four exact differences. Rounding is
/// monotone: products that differ once rounded differ alike, and equal ones are told apart by their
/// errors.
HWY_INLINE MD IsAtOrRight(VD x, VD y, const Edges& e, MD& decided) {
  const DD dd;
  const VD a = hn::Sub(x, e.ax);
  const VD b = hn::Sub(e.cy, e.ay);
  const VD c = hn::Sub(y, e.ay);
  const VD d = hn::Sub(e.cx, e.ax);
  const VD errors = hn::Or(hn::Or(DifferenceError(x, e.ax, a), DifferenceError(e.cy, e.ay, b)),
                           hn::Or(DifferenceError(y, e.ay, c), DifferenceError(e.cx, e.ax, d)));
  decided = hn::Eq(errors, hn::Zero(dd));
  const VD p = hn::Mul(a, b);
  const VD q = hn::Mul(c, d);
  const MD equal = hn::Eq(p, q);
  const MD by_errors = hn::Ge(ProductError(a, b, p), ProductError(c, d, q));
  return hn::Or(hn::Gt(p, q), hn::And(equal, by_errors));
}

/// The same of one centre.
HWY_INLINE bool IsAtOrRight(double x, double y, const ExactEdge& e, bool& decided) {
  const auto error = [](double u, double v, double difference) {
    const double v_seen = u - difference;
    return std::fabs((u - (difference + v_seen)) + (v_seen - v));
  };
  const double a = x - e.ax;
  const double b = e.cy - e.ay;
  const double c = y - e.ay;
  const double d = e.cx - e.ax;
  decided =
      error(x, e.ax, a) + error(e.cy, e.ay, b) + error(y, e.ay, c) + error(e.cx, e.ax, d) == 0;
  const double p = a * b;
  const double q = c * d;
  if (HWY_LIKELY(p != q)) return p > q;
  return std::fma(a, b, -p) >= std::fma(c, d, -q);
}

/// So many open lanes take less time one by one than by vectors.
constexpr int kFewLanes = 2;
HWY_INLINE bool AreFew(std::uint64_t open) { return __builtin_popcountll(open) <= kFewLanes; }

/// Which of the few lanes of `open` have a guess of one column too many, of rows from `row` on, one
/// a lane. `at` as below; edges' ends and centres are those on the target.
template <class Column, class CornersAt>
HWY_INLINE std::uint64_t OneTooMany(const KernelView& view, const Column* columns, int row,
                                    std::uint64_t open, const CornersAt& at) {
  std::uint64_t too_many = 0;
  for (; open != 0; open &= open - 1) {
    const int lane = CountTrailingZeros(open);
    const ExactEdge edge = at(lane);
    const double x = edge.left + (static_cast<double>(columns[lane]) - 0.5);
    const double y = edge.top + (row + lane + 0.5);
    bool decided = false;
    bool is_right = IsAtOrRight(x, y, edge, decided);
    ++view.tiers[0];
    if (HWY_UNLIKELY(!decided)) {
      is_right = IsCentreAtOrRight(edge, x, y);
      ++view.tiers[1];
    }
    too_many |= std::uint64_t{is_right} << lane;
  }
  return too_many;
}

/// Corrects columns in the lanes of `open`, whose guess may be one too many: the crossing is
/// `column` or the one before. `at(lane)` gives a lane's edge as it was given, for those that
/// doubles do not decide.
template <class CornersAt>
HWY_NOINLINE VD Resolve(const KernelView& view, VD column, VD y, const Edges& edges, MD open,
                        const CornersAt& at) {
  const DD dd;
  const VD before = hn::Sub(column, hn::Set(dd, 1.0));
  const VD centre = hn::Sub(column, hn::Set(dd, 0.5));
  MD decided;
  const MD is_right = IsAtOrRight(centre, y, edges, decided);
  const VD resolved = hn::IfThenElse(hn::And(open, is_right), before, column);
  std::uint64_t undecided = MaskBits(dd, hn::AndNot(decided, open));
  view.tiers[0] += static_cast<std::uint64_t>(__builtin_popcountll(MaskBits(dd, open)));
  if (HWY_LIKELY(undecided == 0)) return resolved;
  alignas(64) double columns[kDoubles], centres[kDoubles], heights[kDoubles];
  hn::Store(resolved, dd, columns);
  hn::Store(centre, dd, centres);
  hn::Store(y, dd, heights);
  for (; undecided != 0; undecided &= undecided - 1) {
    const int lane = CountTrailingZeros(undecided);
    const ExactEdge edge = at(lane);
    const bool right = IsCentreAtOrRight(edge, edge.left + centres[lane], edge.top + heights[lane]);
    columns[lane] = centres[lane] + (right ? -0.5 : 0.5);
    ++view.tiers[1];
  }
  return hn::Load(dd, columns);
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_CROSSINGS_H_
