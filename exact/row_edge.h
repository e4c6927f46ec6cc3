// An edge as the rows of a target see it.
#ifndef RASTERPROOF_EXACT_ROW_EDGE_H_
#define RASTERPROOF_EXACT_ROW_EDGE_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/tie_rule.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/edge.h"
#include "exact/sample_frame.h"

namespace rasterproof::exact {

/// Error of x = X + (y - Y) m - offset, m = fl(dx / dy), as a crossing of the row y in [Y, Y + dy],
/// in units of M + 1, M = max |x| over the edge's ends.
///
/// y - Y, dx, dy, the quotient and the product round once each, relative to |(y - Y) dx / dy| <=
/// |dx| <= 2 M: 5 * 2 M u. The sum with X - offset rounds twice, relative to at most M + 1 each:
/// 2 (M + 1) u. The caller's at +- error: (M + 1) u. Together, second orders included, below
/// (13.1 M + 3.1) u; 16 leaves room.
/// Proof:      reference/proofs/row_crossing.g.
/// Measured:   0.653 of the error is needed, the caller's rounding included: docs/mathematics.md,
///             9, has the witness; 0.390 MeasuredBounds, 80000 inputs climbing from seed 66.
inline constexpr double kCrossingErrorMultiplier = 16 * rounding_epsilon<double>();
/// The quotient underflows by at most 2^-1075, times y - Y < 2^1024: 2^-51; the product's own
/// underflow is negligible.
/// Measured:   0.083 of the error is needed where the slope underflows: as above, 20000 inputs,
///             seed 67.
inline constexpr double kCrossingUnderflowError = 0x1p-50;
/// Beyond, at M of about 2^1000, sums and products could overflow; an infinite slope (a flat edge,
/// or one of subnormal height) bounds nothing either. Then exact signs decide, by bisection over
/// the columns.
inline constexpr double kLargestKnownError = 0x1p951;

/// An edge from its upper end to its lower end: the same arithmetic in both triangles that share
/// it.
///
/// Domain:     finite ends in screen axes, upper.y <= lower.y.
class RowEdge {
 public:
  RowEdge(Point2 upper, Point2 lower) : upper_(upper), lower_(lower) {
    const double dx = lower.x - upper.x;
    const double dy = lower.y - upper.y;
    slope_ = dx / dy;
    error_ = kCrossingErrorMultiplier * (std::max(std::fabs(upper.x), std::fabs(lower.x)) + 1) +
             kCrossingUnderflowError;
    known_ = error_ <= kLargestKnownError && std::isfinite(dy) && std::isfinite(slope_);
  }

  /// Where the row at y crosses, in columns of the samples at column + offset.
  Guess At(double y, double offset) const {
    if (!known_) return {0, std::numeric_limits<double>::infinity()};
    return {upper_.x - offset + (y - upper_.y) * slope_, error_};
  }
  /// Sign of the shifted sample's side: +1 right of the edge (dE/dx = dy > 0).
  int Side(Point2 p, const TieRule& rule) const { return ShiftedEdgeSign(upper_, lower_, p, rule); }
  /// The first column of the clip rectangle whose Side in the row is at least least_sign. Adds one
  /// to `certain` if the guess alone decides; otherwise the exact signs count their own tiers.
  int FirstColumnAtSide(const SampleFrame& frame, int row, std::size_t s, int least_sign,
                        std::uint64_t& certain) const {
    if (!frame.scanline_rounding.IsNone()) {
      return FirstColumnAtRounded(frame, row, s, least_sign, certain);
    }
    const Guess guess = At(row + frame.offsets[s].y, frame.offsets[s].x);
    return FirstColumn(guess, frame.clip.x0, frame.clip.x1, certain, [&](int column) {
      return Side(frame.At(column, row, s), frame.rule) >= least_sign;
    });
  }

 private:
  int FirstColumnAtRounded(const SampleFrame& frame, int row, std::size_t s, int least_sign,
                           std::uint64_t& certain) const;

  Point2 upper_;
  Point2 lower_;
  double slope_ = 0;
  double error_ = 0;
  bool known_ = false;
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_ROW_EDGE_H_
