// Values of a triangle at a point, estimated in double: what is far from its bound needs no
// rationals, and what legal choices leave open is an interval of them.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_ESTIMATES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_ESTIMATES_H_

#include <array>
#include <limits>

#include "core/channel.h"
#include "core/vertex.h"

namespace rasterproof::props {

/// A corner before the division by w: its place in the window is (x / w, y / w).
struct RayCorner {
  double x = 0;
  double y = 0;
  double w = 1;
};
using RayCorners = std::array<RayCorner, 3>;

/// What the forms in use may be off in units of rounding, where a subject states nothing. Beside
/// the products of the condition they have others: of differences from either end of an edge, of
/// the area, of numbers that are taken from one vertex's. Infinite where a w is not positive.
///
/// Tested, not proved: kUsualConditions of them bound the plain forms of reference/value_methods.h
/// in float32, each of which is proved to stay within 11 conditions about a point of its own.
/// Measured:   largest error / allowed of 4,000 triangles a form, seed 1: 0.068 (vertex-plane); of
///             the others at most 0.041: UsualConditions.AreNotExceededByAnyFormInUse, 2026-11-28.
struct UsualConditions {
  double value = std::numeric_limits<double>::infinity();
  std::array<double, 2> derivatives{std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()};
  double denominator = std::numeric_limits<double>::infinity();
};

/// A value, its condition (exact/values.h) and those of its derivatives by x and by y, each within
/// kEstimateError times its condition. Not finite where the denominator is 0 or something
/// overflows.
struct ValueEstimate {
  double value = 0;
  double condition = 0;
  std::array<double, 2> derivatives{};
  std::array<double, 2> derivative_conditions{};
  double denominator = 0;  ///< its sign tells the sides of the horizon apart
  std::array<double, 2> denominator_slopes{};
  double denominator_condition = 0;  ///< of the denominator alone, relative to it
};

/// Each of the few dozen roundings in a value, times the sum of magnitudes that it belongs to, is
/// below 2^-53 of the condition.
inline constexpr double kEstimateError = 0x1p-46;

/// The value of numbers at the corners.
///
/// Domain:     finite corners; an interpolation other than kFlat. The numbers of kInverseW are 1
///             for 1/w, and the corners' z for a depth.
ValueEstimate EstimateValue(const RayCorners& v, Interpolation interpolation,
                            const std::array<double, 3>& a, Point2 p);
/// Domain:     as above.
UsualConditions UsualConditionsOf(const RayCorners& v, Interpolation interpolation,
                                  const std::array<double, 3>& a, Point2 p);

/// Numbers in proportion to the exact weights of the vertices at p: beta_i w_i^power. 0: in
/// perspective, 1: on the screen; the others are what mistakes make of them.
std::array<double, 3> WeightsOfPower(const RayCorners& v, int power, Point2 p);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_ESTIMATES_H_
