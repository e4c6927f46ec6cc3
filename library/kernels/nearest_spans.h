// Correctly rounded values of rows: quotients in double, of which a float32 is told wherever no
// middle of two floats lies within what they may be off (value_errors.h).
#ifndef RASTERPROOF_LIBRARY_KERNELS_NEAREST_SPANS_H_
#define RASTERPROOF_LIBRARY_KERNELS_NEAREST_SPANS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/value_errors.h"
#include "library/kernels/value_set_up.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> v, float* p, int n) {
  if (n >= kLanesOf<D>) {
    hn::StoreU(v, d, p);
  } else {
    hn::BlendedStore(v, hn::FirstN(d, static_cast<std::size_t>(n)), d, p);
  }
}

/// a b + c, rounded once or twice.
HWY_INLINE double NearlyFused(double a, double b, double c) {
#if HWY_NATIVE_FMA
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// A line along a row: x + row, off by `error` at most.
struct RowLine {
  double x, row, error;

  HWY_INLINE double At(double column) const { return NearlyFused(x, column, row); }
};

/// Columns [x0, x1) of a row, counted from the corner of a triangle's pixel.
struct LocalSpan {
  int row, x0, x1;

  HWY_INLINE LocalSpan(const ValueSetUp& t, int y, int first, int last)
      : row(y - t.top), x0(first - t.left), x1(last - t.left) {}
};
HWY_INLINE RowLine RowOf(const ReachLine& line, const LocalSpan& at) {
  const double y = at.row + 0.5;
  const double x_reach = Greatest(Magnitude(at.x0), Magnitude(at.x1));
  const double reach =
      NearlyFused(line.a_reach, x_reach, NearlyFused(line.b_reach, Magnitude(y), line.c_reach));
  return {line.a, NearlyFused(line.b, y, line.c), kLineError * reach};
}

/// n / d over a row; r = 1 / d where d is one number.
struct NearestRow {
  RowLine n, d;
  double r;
};

/// 1 / d within kQuotientError.
HWY_INLINE VD Reciprocal(VD d) {
#if HWY_TARGET == HWY_AVX3
  const VD r{_mm512_rcp14_pd(d.raw)};
  const VD h = hn::NegMulAdd(d, r, hn::Set(DD(), 1.0));
  return hn::MulAdd(r, hn::MulAdd(h, h, h), r);
#else
  return hn::Div(hn::Set(DD(), 1.0), d);
#endif
}

/// n / d within kQuotientError.
HWY_INLINE VD Quotient(VD n, VD d) {
#if HWY_TARGET == HWY_AVX3
  const VD r{_mm512_rcp14_pd(d.raw)};
  const VD h = hn::NegMulAdd(d, r, hn::Set(DD(), 1.0));
  const VD q = hn::Mul(n, r);
  return hn::MulAdd(q, hn::MulAdd(h, h, h), q);
#else
  return hn::Div(n, d);
#endif
}

alignas(64) constexpr double kFirstCentres[kBlock / 2] = {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5};

HWY_INLINE VD CentresFrom(int column) {
  return hn::Add(hn::Set(DD(), static_cast<double>(column)), hn::Load(DD(), kFirstCentres));
}

/// A double has 29 bits more than a float: the middles of two floats are those of which the first
/// alone is set.
constexpr std::int64_t kMiddle = std::int64_t{1} << 28;

/// How a value is divided.
enum class Divided { kByNumber, kByLine, kByReciprocals };

/// Writes columns [x0, x1). Returns whether any is within `doubt` places, a power of two up to
/// 2^27, of a middle; with kDecides decide(column) tells those. reciprocals: of column x0.
template <Divided kHow, bool kDecides, class Decide>
HWY_INLINE bool FillNearest(const NearestRow& row, int x0, int x1, std::int64_t doubt,
                            const double* reciprocals, float* value, const Decide& decide) {
  const DD dd;
  const DDF df;
  const hn::RebindToSigned<DD> di;
  const VD n_x = hn::Set(dd, row.n.x);
  const VD d_x = hn::Set(dd, row.d.x);
  const VD n_row = hn::Set(dd, row.n.row);
  const VD d_row = hn::Set(dd, row.d.row);
  const VD r = hn::Set(dd, row.r);
  const auto shift = hn::Set(di, doubt - kMiddle);
  const auto told = hn::Set(di, 2 * kMiddle - 2 * doubt);  // the bits that tell
  const VD step = hn::Set(dd, static_cast<double>(kDoubles));
  const int width = x1 - x0;
  VD x = CentresFrom(x0);
  std::uint64_t any = 0;
  for (int at = 0; at < width; at += kDoubles) {
    VD q = hn::MulAdd(n_x, x, n_row);
    if constexpr (kHow == Divided::kByLine) {
      q = Quotient(q, hn::MulAdd(d_x, x, d_row));
    } else if constexpr (kHow == Divided::kByReciprocals) {
      q = hn::Mul(q, hn::LoadU(dd, reciprocals + at));
    } else {
      q = hn::Mul(q, r);
    }
    StoreFirst(df, hn::DemoteTo(df, q), value + at, width - at);
    const auto bits = hn::Add(hn::BitCast(di, q), shift);
    std::uint64_t open = MaskBits(di, hn::Eq(hn::And(bits, told), hn::Zero(di)));
    if (width - at < kDoubles) open &= (std::uint64_t{1} << (width - at)) - 1;
    any |= open;
    if constexpr (kDecides) {
      for (; open != 0; open &= open - 1) {
        const int lane = CountTrailingZeros(open);
        value[at + lane] = decide(x0 + at + lane);
      }
    }
    x = hn::Add(x, step);
  }
  return any != 0;
}

/// What a row takes that is not told at once. The lines are found again from the set-up: a row's
/// own whose address is taken would be written and read back as it is made.
struct NearestLines {
  const ReachLine* n;
  const ReachLine* d;
  double r;

  HWY_INLINE NearestRow RowAt(const LocalSpan& at) const {
    return {RowOf(*n, at), RowOf(*d, at), r};
  }
};

/// The second pass over a row, which few need.
template <Divided kHow, class Decide>
HWY_NOINLINE void DecideNearest(NearestLines lines, LocalSpan at, std::int64_t doubt,
                                const double* reciprocals, float* value, Decide decide) {
  FillNearest<kHow, true>(lines.RowAt(at), at.x0, at.x1, doubt, reciprocals, value, decide);
}

/// Both ends of a line over columns [x0, x1), between which it lies.
struct LineEnds {
  double least, most;  ///< in size
  bool has_sign;       ///< one sign at both ends

  HWY_INLINE LineEnds(const RowLine& line, int x0, int x1) {
    const double first = line.At(x0 + 0.5);
    const double last = line.At(x1 - 0.5);
    has_sign = first * last > 0;
    least = Least(Magnitude(first), Magnitude(last));
    most = Greatest(Magnitude(first), Magnitude(last));
  }
};

/// The doubt of a quotient of columns [x0, x1), or -1 where none is bounded so. Both lines are
/// least and greatest at an end.
inline std::int64_t DoubtOf(const NearestRow& row, const LineEnds& n, const LineEnds& d) {
  const bool is_bounded = row.n.error < kMostShare * n.least && row.d.error < kMostShare * d.least;
  if (!is_bounded) return -1;
  const double share = row.n.error / n.least + row.d.error / d.least + kQuotientError;
  const double places = share * (1 + 0x1p-10) * 0x1p53 + 2;
  // The power of two above.
  const auto exponent = __builtin_bit_cast(std::uint64_t, places) >> 52;
  return std::int64_t{1} << (exponent - 1023 + 1);
}

template <Divided kHow, class Decide>
HWY_NOINLINE void DrawDoubtful(NearestLines lines, LocalSpan at, const double* reciprocals,
                               float* value, Decide decide) {
  constexpr int kLeast = 8;  // columns that are worth another try
  const NearestRow row = lines.RowAt(at);
  const LineEnds n(row.n, at.x0, at.x1);
  const LineEnds d(row.d, at.x0, at.x1);
  const bool is_normal = n.least > 0x1p-125 * d.most && n.most < 0x1p127 * d.least;
  const std::int64_t doubt = n.has_sign && d.has_sign && is_normal ? DoubtOf(row, n, d) : -1;
  const int width = at.x1 - at.x0;
  if (doubt >= 0) {
    if (FillNearest<kHow, false>(row, at.x0, at.x1, doubt, reciprocals, value, decide)) {
      DecideNearest<kHow>(lines, at, doubt, reciprocals, value, decide);
    }
  } else if (width > kLeast) {
    const int half = width / 2;
    LocalSpan first = at;
    first.x1 = at.x0 + half;
    at.x0 = first.x1;
    DrawDoubtful<kHow>(lines, first, reciprocals, value, decide);
    DrawDoubtful<kHow>(lines, at, reciprocals + half, value + half, decide);
  } else {
    for (int x = at.x0; x < at.x1; ++x) value[x - at.x0] = decide(x);
  }
}

/// A row of which the set-up does not know enough.
template <Divided kHow, class Decide>
HWY_NOINLINE void DrawBounded(NearestLines lines, LocalSpan at, const double* reciprocals,
                              float* value, Decide decide) {
  constexpr double kPart = 1 / kQuickShare;
  const NearestRow row = lines.RowAt(at);
  const LineEnds n(row.n, at.x0, at.x1);
  const LineEnds d(row.d, at.x0, at.x1);
  const bool is_quick = n.has_sign & d.has_sign & (n.least >= kPart * row.n.error) &
                        (d.least >= kPart * row.d.error) & (n.least > 0x1p-125 * d.most) &
                        (n.most < 0x1p127 * d.least);
  if (!is_quick) {
    DrawDoubtful<kHow>(lines, at, reciprocals, value, decide);
  } else if (FillNearest<kHow, false>(row, at.x0, at.x1, kQuickDoubt, reciprocals, value, decide)) {
    DecideNearest<kHow>(lines, at, kQuickDoubt, reciprocals, value, decide);
  }
}

/// A row of one channel; reciprocals where they are asked for.
template <Divided kHow, class Decide>
HWY_INLINE void DrawNearest(const NearestLines& lines, int quick, const LocalSpan& at,
                            const double* reciprocals, float* value, const Decide& decide) {
  const bool is_quick = (at.x1 <= quick) & (-at.x0 <= quick) &
                        (static_cast<unsigned>(at.row) < static_cast<unsigned>(quick));
  if (HWY_UNLIKELY(!is_quick)) {
    DrawBounded<kHow>(lines, at, reciprocals, value, decide);
  } else if (HWY_UNLIKELY((FillNearest<kHow, false>(lines.RowAt(at), at.x0, at.x1, kQuickDoubt,
                                                    reciprocals, value, decide)))) {
    DecideNearest<kHow>(lines, at, kQuickDoubt, reciprocals, value, decide);
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_NEAREST_SPANS_H_
