// How the field interpolates the numbers at a triangle's vertices, each way with a proved bound.
#ifndef RASTERPROOF_REFERENCE_VALUE_METHODS_H_
#define RASTERPROOF_REFERENCE_VALUE_METHODS_H_

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/ulp.h"

namespace rasterproof::reference {

/// A corner before the division by w; its place in the window is (x / w, y / w).
template <class T>
struct ValueCorner {
  T x = 0;
  T y = 0;
  T w = 1;
};

/// What is interpolated, and where.
///
/// Domain:     finite, w not 0 and 1 in the window. No product overflows or underflows. Each x that
///             is stepped to is a number of T.
template <class T>
struct ValueTask {
  std::array<ValueCorner<T>, 3> v{};
  std::array<T, 3> a{};  ///< the numbers at the corners
  T x = 0;
  T y = 0;
  int steps = 0;  ///< of one pixel each along the row, before the point that is asked for
};

enum class ValueSpace : std::uint8_t {
  kWindow,  ///< every w is 1
  kClip     ///< any w
};

/// Which point the condition of exact/values.h counts coordinates from: the value of a triangle and
/// a sample that are moved together is the same, its condition is not.
enum class ConditionAbout : std::uint8_t {
  kOrigin,       ///< the window's, as exact/values.h has it
  kFirstVertex,  ///< the corner that differences are taken from
  kEdgeStart     ///< for each edge value its own: the M_i of three moves
};

/// Of which number the error is stated, and of which point's condition.
enum class ValueTarget : std::uint8_t {
  kValue,       ///< at (x, y)
  kAfterSteps,  ///< at (x + steps, y); of the larger condition of both ends
  kDifference   ///< from (x, y) to (x + 1, y), d/dx in the window; of the sum of both conditions
};

// A bound of k conditions says: each product of an edge value, times its a_i, carries at most k
// roundings in the numerator n, and at most k in the denominator d, or k - 1 where the quotient is
// rounded last. For n off by dn and d by dd, and a rounding r of the quotient,
//     n'/d' (1 + r) - n/d = (dn - v dd) (1 + r) / d' + r v,      |r v| <= u sum M_i |v| / |d|.
// With |dn| <= ((1 + u)^k - 1) sum M_i |a_i| and |dd| <= ((1 + u)^(k-1) - 1) sum M_i both parts of
// the condition C = sum M_i (|a_i| + |v|) / |d| are multiplied by at most
// (1 + u)^(k+1) - 1 - u <= (k + kSecondOrder) u, and |d'| >= (1 - e) |d| is the growth that
// core/value_rule.h allows. Proof of that step: proofs/value_methods.g, for k from 8 to 11; the
// counts are below. docs/mathematics.md, 6.

/// What roundings add to second order, in conditions.
/// Measured:   value_figures.cc has the largest error / bound known of each method; what
///             ValueMethods.NoSearchExceedsTheirBounds finds is held to it. Sums of ten roundings
///             that all have one sign were not found: the bounds are safe, not tight.
inline constexpr double kSecondOrder = 0x1p-16;

/// Edge values E of two differences each: 4 (differences, product, subtraction). n: the quotient,
/// the product, two sums: 8. d: two sums: 6.
inline constexpr double kEdgeProductsConditions = 8 + kSecondOrder;

/// E 4, quotient 5, the numbers' difference 6, product 7, two sums: 9; a_0 carries two sums and the
/// area 4. About v_0, M_0 = M_1 + M_2 + |X_1 Y_2| + |X_2 Y_1|, so that the condition has room for
/// M_k |a_0| and for the area's part |a_0| + |v|.
/// Fused: the two last products are not rounded: 8.
inline constexpr double kDifferencesConditions = 9 + kSecondOrder;
inline constexpr double kFusedDifferencesConditions = 8 + kSecondOrder;

/// A: difference, product, two sums, quotient, product, two sums: 8. C: 7. The area: 4.
inline constexpr double kOriginPlaneConditions = 8 + kSecondOrder;

/// A: two differences, product, subtraction, quotient, that of the point, product, two sums: 9.
inline constexpr double kVertexPlaneConditions = 9 + kSecondOrder;

/// The plane from the first vertex at the start: 9 C. n A: its own 5 roundings and the area's 4 on
/// products of n, which is no more than both distances from v_0: 5 (C + C'). Each step rounds a
/// value between both ends', of at most half the larger condition.
///
/// Domain:     at most 4096 steps: (1 + u)^4096 is within 2^-11 of 1.
/// Measured:   ValueMethods.SteppingDriftsByHalfAnUlpAStep, 4096 steps in float32
inline constexpr double kSteppedConditions = 19.01;
inline constexpr double kSteppedConditionsAStep = 0.501;
inline constexpr int kMostValueSteps = 4096;

/// X, Y, 1/w one rounding each and a/w two. n: 2 for A of a vertex, 5 with a/w, sums 7, product 8,
/// sums: 10. C: 4 for X_j Y_k - X_k Y_j: 10. d: one less, and the quotient. About the origin
/// |w_j w_k| X_j Y_k is a product of the homogeneous edge value.
/// Fused: C meets both last sums: 11.
inline constexpr double kPerspectivePlanesConditions = 10 + kSecondOrder;
inline constexpr double kFusedPerspectivePlanesConditions = 11 + kSecondOrder;

/// The adjugate 2, products with the numbers 3, sums 5, product with the point 6, sums: 8. d: 7.
inline constexpr double kInverseMatrixConditions = 8 + kSecondOrder;

/// beta_i 5 (proofs/homogeneous.g), quotient 6, product 7, sums: 9. d: 7.
inline constexpr double kPerspectiveWeightsConditions = 9 + kSecondOrder;

/// The relative error of 1/d from an estimate of some bits, after Newton steps r (2 - d r).
///
/// e becomes -e^2 and what three roundings make. Proof: proofs/value_methods.g.
/// Domain:     12 bits at least.
template <class T>
constexpr double ReciprocalError(int bits, int newton_steps) {
  double e = 1;
  for (int i = 0; i < bits; ++i) e /= 2;
  for (int i = 0; i < newton_steps; ++i) e = e * e + 3 * (1 + 0x1p-10) * rounding_epsilon<T>();
  return e;
}

/// The inverse matrix with n times an estimated 1/d: the estimate's error and the product's
/// rounding count on |v| <= C / 2. 2^-8: the estimate's error of 8 roundings.
template <class T>
constexpr double ReciprocalConditions(int bits, int newton_steps) {
  return 8 + 0x1p-8 + (1 + ReciprocalError<T>(bits, newton_steps) / rounding_epsilon<T>()) / 2;
}

/// Two values by differences, 9 (C + C'), and the subtraction, of at most half as much.
inline constexpr double kQuadDifferenceConditions = 9.5 + kSecondOrder;

/// Correctly rounded, ties to even. Tight: refuted when lowered by 1 %.
inline constexpr double kCorrectlyRoundedUlps = 0.5;

/// A row of the table. Its conditions are those of core/value_rule.h: they grow where the
/// denominator is off, and state nothing where it may be off by half.
struct ValueMethod {
  std::string_view name;
  std::string_view computes;
  ValueSpace space;
  ConditionAbout about;
  ValueTarget target;
  std::array<double, 2> conditions;  ///< in float32, float64
  double conditions_a_step;
  double ulps;
  bool equal_stay_equal;   ///< equal numbers at the corners give that number, to the bit
  bool exact_at_vertices;  ///< at a corner of the window its number, to the bit
  bool stays_in_hull;      ///< in the closed triangle
  float (*float32)(const ValueTask<float>& task);
  double (*float64)(const ValueTask<double>& task);

  double ConditionsOf(bool is_float, int steps) const {
    return conditions[is_float ? 0 : 1] + conditions_a_step * steps;
  }
};

/// All of them. Where the computed denominator is 0 the value is not finite.
std::span<const ValueMethod> ValueMethods();

/// The value sum beta_i a_i / sum beta_i of exact/values.h, correctly rounded to T: where a filter
/// in double does not decide, by the sign of exact sums at the middles of neighbours.
///
/// Domain:     products of two coordinates in [2^-960, 2^1020] or 0; |value| <= max.
/// Returns:    NaN if the denominator is 0.
/// Cost:       float32: mostly the filter's 100 operations. What that leaves open, and all of
///             float64: 63 exact sums of 144 products.
template <class T>
T CorrectlyRoundedValue(const ValueTask<T>& task);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_VALUE_METHODS_H_
