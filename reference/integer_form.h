// Fixed point: E of snapped vertices in integers, exact inside a stated domain.
#ifndef RASTERPROOF_REFERENCE_INTEGER_FORM_H_
#define RASTERPROOF_REFERENCE_INTEGER_FORM_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/snap.h"
#include "core/vertex.h"
#include "reference/edge_forms.h"

namespace rasterproof::reference {

/// Largest coordinate, in pixels, whose integer rows are proved not to overflow.
///
/// The direct form sees differences only: with all vertices and every evaluated point in a box of
/// side W, |E| and both its products are at most (W 2^s)^2 (E is affine in each coordinate, so its
/// extremes lie at the box's corners). A row steps at most one pixel past the box.
///   int64, s = 8: W = 2 * 2^22 + 1: W 2^8 = 2147483904 <= 3037000499 = floor(sqrt(2^63 - 1)).
///   int32, s = 4: W = 2 * 1440 + 1: W 2^4 = 46096 <= 46340 = floor(sqrt(2^31 - 1)).
/// These sources themselves, run on ranges: tests/reference/integer_ranges_test.cc. They would hold
/// up to 5931641.3 and 1447.8 pixels.
template <class I>
inline constexpr double kIntegerCoordinateLimit = 0;
template <>
inline constexpr double kIntegerCoordinateLimit<std::int64_t> = 0x1p22;
template <>
inline constexpr double kIntegerCoordinateLimit<std::int32_t> = 1440;

/// E in units of (2^-kBits px)^2. Points are snapped by the caller; samples lie on the grid.
template <class I, int kBits>
class IntegerForm {
 public:
  using Scalar = I;
  using Point = PointOf<I>;
  static constexpr Snap kSnap{kBits, SnapRule::kNearestEven};
  static constexpr int kOne = 1 << kBits;  ///< one pixel

  IntegerForm(Point a, Point b, bool reversed)
      : x_(a.x),
        y_(a.y),
        dx_(reversed ? a.x - b.x : b.x - a.x),
        dy_(reversed ? a.y - b.y : b.y - a.y) {}

  /// Another snap than the one that the oracle uses, so that the two can disagree.
  static Point2 Snapped(Point2 p) { return {Snapped(p.x), Snapped(p.y)}; }
  static bool Fits(Point2 p) {
    return std::fabs(p.x) <= kIntegerCoordinateLimit<I> &&
           std::fabs(p.y) <= kIntegerCoordinateLimit<I>;
  }
  /// Domain:     p on the grid, Fits(p).
  static Point Convert(Point2 p) {
    return {static_cast<I>(p.x * double{kOne}), static_cast<I>(p.y * double{kOne})};
  }
  static I Centre(int n) { return static_cast<I>(n) * kOne + kOne / 2; }
  I At(I x, I y) const { return (x - x_) * dy_ - (y - y_) * dx_; }
  I StepX() const { return dy_ * kOne; }
  I StepY() const { return -dx_ * kOne; }

 private:
  static double Snapped(double x) {
    // Every double from here on is a multiple of the step. NaN is no less. -0 becomes +0.
    constexpr double kAllOnGridFrom = 0x1p52 / double{kOne};
    return std::fabs(x) < kAllOnGridFrom ? std::nearbyint(x * double{kOne}) / double{kOne} + 0.0
                                         : x;
  }

  I x_, y_, dx_, dy_;
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_INTEGER_FORM_H_
