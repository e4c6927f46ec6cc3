// The exact kernel's rows in steps of fixed point: those of one triangle, one a lane.
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_STEPS_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_STEPS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Where rows cross one edge, in 32.32 fixed point modulo 2^64: right in its own rows.
class SteppedEdge {
 public:
  /// Returns false where the edge is too flat. [first, end) are its rows, `row` is the first one
  /// that is asked for; at(y) is the guess of where height y crosses it.
  template <class At>
  HWY_INLINE bool Start(double slope, int first, int end, int row, const At& at) {
    at_ = 0;
    step_ = 0;
    lanes_ = hn::Zero(DI());
    if (first >= end) return true;
    if (!(slope > -kSteppedSlope && slope < kSteppedSlope)) return false;
    const double crossing = at(first + 0.5);
    step_ = Fixed(slope);
    at_ = Fixed(crossing) - static_cast<std::uint64_t>(first - row) * step_;
    const DU du;
    const VU lane = hn::BitCast(du, hn::ConvertTo(DI(), FloatsFrom(DF(), 0)));
    const VU high = hn::Set(du, static_cast<std::uint32_t>(step_ >> kSmallBits));
    const VU low = hn::Set(du, static_cast<std::uint32_t>(step_ & kSmallFraction));
    const VU carry = hn::ShiftRight<kSmallBits>(hn::Mul(lane, low));
    lanes_ = hn::BitCast(DI(), hn::Add(hn::Mul(lane, high), carry));
    return true;
  }

  /// The crossings of the next kLanes rows, in 16.16 fixed point.
  HWY_INLINE VI Next() {
    const DI di;
    const auto at = static_cast<std::int32_t>(static_cast<std::uint32_t>(at_ >> kSmallBits));
    at_ += kLanes * step_;
    return hn::Add(hn::Set(di, at), lanes_);
  }

 private:
  HWY_INLINE static std::uint64_t Fixed(double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(v * 0x1p32));
  }

  std::uint64_t at_, step_;
  VI lanes_;  ///< multiples of step_
};

/// Decides the rows from `row` on, bits of `valid`, whose guesses do not tell.
inline HWY_NOINLINE void ResolveSteps(const KernelView& view, const ExactBlock& block, int i,
                                      int row, std::uint64_t valid, VI& by_long, VI& by_short) {
  const DI di;
  const DD dd;
  const DDI ddi;
  const VD middle = hn::Set(dd, static_cast<double>(block.y[1][i]));
  alignas(64) std::int32_t columns[kLanes];
  const auto resolve = [&](VI& guess, bool is_long) {
    const std::uint64_t open = valid & MaskBits(di, HasOpenFraction(guess, 2 * kStepError));
    if (open == 0) return;
    hn::Store(hn::ShiftRight<kSmallBits>(guess), di, columns);
    if (AreFew(open)) {
      const std::uint64_t too_many = OneTooMany(view, columns, row, open, [&](int lane) {
        const bool is_upper = row + lane + 0.5 < double{block.y[1][i]};
        return block.EdgeOf(is_long ? kLongEdge : is_upper ? kUpperEdge : kLowerEdge, i);
      });
      const VI one = hn::Set(di, 1 << kSmallBits);
      guess = hn::Sub(guess, hn::IfThenElseZero(MaskOf(di, too_many), one));
      return;
    }
    for (int h = 0; h < kLanes; h += kDoubles) {
      const std::uint64_t bits = (open >> h) & ((std::uint64_t{1} << kDoubles) - 1);
      if (bits == 0) continue;
      const VD centre = DoublesFrom(row + h + 0.5);
      const VD column = hn::PromoteTo(dd, hn::Load(ddi, columns + h));
      const std::uint64_t upper = MaskBits(dd, hn::Lt(centre, middle));
      const VD resolved = ResolveRows(view, block, i, column, centre, bits, upper, is_long);
      hn::Store(hn::DemoteTo(ddi, resolved), ddi, columns + h);
    }
    guess = hn::ShiftLeft<kSmallBits>(hn::Load(di, columns));
  };
  resolve(by_long, true);
  resolve(by_short, false);
}

/// Draws a triangle that may be stepped. Returns false, with nothing drawn, where an edge is too
/// flat.
template <bool kExact, class Sink>
HWY_INLINE bool DrawSteps(const KernelView& view, const ExactBlock& block, int i,
                          std::uint32_t triangle, Sink& sink) {
  const DI di;
  const Box box = block.BoxOf(i);
  const int middle = Least(Greatest(block.middle_row[i], box.y0), box.y1);
  SteppedEdge whole, upper, lower;
  const auto start = [&](SteppedEdge& edge, int e, int first, int end) {
    const double slope = block.long_slope[e][i];
    const int a = kStartOf[e];
    return edge.Start(slope, first, end, box.y0, [&](double y) {
      return (y - double{block.y[a][i]}) * slope + (block.x[a][i] + (0.5 + kStepError));
    });
  };
  if (!start(whole, kLongEdge, box.y0, box.y1)) return false;
  if (!start(upper, kUpperEdge, box.y0, middle)) return false;
  if (!start(lower, kLowerEdge, middle, box.y1)) return false;
  const VI lane = hn::ConvertTo(di, FloatsFrom(DF(), 0));
  const VI columns = hn::Set(di, view.width);
  bool has_begun = !Sink::kNeedsFacing;
  if (has_begun) sink.Begin(triangle, false, block.PlaneOf(i));
  for (int row = box.y0; row < box.y1; row += kLanes) {
    const int rows = Least(kLanes, box.y1 - row);
    const std::uint64_t valid = (std::uint64_t{1} << rows) - 1;
    VI by_long = whole.Next();
    const auto is_upper = hn::Lt(lane, hn::Set(di, middle - row));
    const VI by_upper = upper.Next();
    VI by_short = hn::IfThenElse(is_upper, by_upper, lower.Next());
    if constexpr (kExact) {
      const auto open = HasOpenFraction(LesserFractions(by_long, by_short), 2 * kStepError);
      if (HWY_UNLIKELY((MaskBits(di, open) & valid) != 0)) {
        ResolveSteps(view, block, i, row, valid, by_long, by_short);
      }
    }
    const auto column = [&](VI guess) {
      return hn::Max(hn::Min(hn::ShiftRight<kSmallBits>(guess), columns), hn::Zero(di));
    };
    const VI long_column = column(by_long);
    const VI short_column = column(by_short);
    if constexpr (Sink::kNeedsFacing) {
      const std::uint64_t differ = valid & ~MaskBits(di, hn::Eq(long_column, short_column));
      if (!has_begun && differ != 0) {
        const std::uint64_t left = differ & MaskBits(di, hn::Lt(long_column, short_column));
        sink.Begin(triangle, IsFrontBy(left != 0, ((block.odd >> i) & 1) != 0), block.PlaneOf(i));
        has_begun = true;
      }
      if (!has_begun) continue;  // nothing is covered so far
    }
    EmitRows(sink, box.x1 - box.x0, row, rows, hn::Min(long_column, short_column),
             hn::Max(long_column, short_column));
  }
  return true;
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_STEPS_H_
