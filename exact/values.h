// Exact interpolated values and their derivatives, correctly rounded, and whether a shown number
// lies within a stated bound of them. Homogeneous: nothing is divided by w, corners may have any w.
#ifndef RASTERPROOF_EXACT_VALUES_H_
#define RASTERPROOF_EXACT_VALUES_H_

#include <array>
#include <cstdint>
#include <optional>

#include "core/channel.h"
#include "core/scene.h"
#include "core/value_rule.h"
#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::exact {

/// A corner before the division by w. Its place in the window is (x / w, y / w).
///
/// Domain:     w of any sign, 0 included.
struct HomogeneousPoint {
  Rational x;
  Rational y;
  Rational w;
};
using HomogeneousTriangle = std::array<HomogeneousPoint, 3>;

/// The corners of clip space: x, y and w as they are.
HomogeneousTriangle ClipTriangle(const std::array<Vertex, 3>& v);
/// The corners (X w, Y w, w) of points of the window. A w of 0 makes the triangle degenerate.
HomogeneousTriangle WindowTriangle(const std::array<Point2, 3>& v,
                                   const std::array<double, 3>& w = {1, 1, 1});

/// A number a_i at each corner.
using Attribute = std::array<Rational, 3>;
/// What makes kInverseW the value 1/w.
inline Attribute Ones() { return {1, 1, 1}; }
/// Domain:     finite.
inline Attribute ToAttribute(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// A number and its derivatives along the window's axes.
///
/// Units:      the value's; for dx and dy, per pixel.
struct ValueAndDerivatives {
  Rational value;
  Rational dx;
  Rational dy;
};

/// What interpolation gives at one point of the window, inside the triangle or not.
///
/// With beta_i = (V_j x V_k) . (p.x, p.y, 1), (i, j, k) cyclic, S = sum beta_i and
/// D = det(V_0, V_1, V_2) = sum beta_i w_i:
///
///     kPerspective   sum beta_i a_i / S
///     kLinear        sum beta_i w_i a_i / D
///     kInverseW      sum beta_i a_i / D: a / w of the value a in perspective. 1/w for Ones(), the
///                    depth z/w for the corners' z of clip space, both for any w.
///
/// Each is n / d, where n = sum beta_i c_i and d = sum beta_i e_i; beta_i is affine in p. So
/// d/dx = (dn/dx - value dd/dx) / d, exactly.
///
/// Domain:     finite p.
/// Returns:    every function: nothing if D = 0, if kPerspective has S = 0 (the point lies on the
///             triangle's horizon, where 1/w = 0), and for kFlat, which interpolates nothing.
/// Error:      none.
/// Cost:       rationals: some microseconds each. One object serves all attributes at its point.
class Interpolant {
 public:
  Interpolant(HomogeneousTriangle corners, Point2 p);

  /// The factors of the a_i in Value: beta_i / S (kPerspective), beta_i w_i / D (kLinear, the
  /// barycentrics on the screen), beta_i / D (kInverseW). The first two sum to one, the third to
  /// 1/w.
  std::optional<std::array<Rational, 3>> Weights(Interpolation interpolation) const;
  std::optional<Rational> Value(Interpolation interpolation, const Attribute& a) const;
  std::optional<ValueAndDerivatives> Derivatives(Interpolation interpolation,
                                                 const Attribute& a) const;

  /// What a stated error may be relative to: a first-order bound on how far the value, and each
  /// derivative, moves when each of the products that make up each beta_i is off by at most one
  /// relative unit. With M_i and X_i the sums of the magnitudes of the products in beta_i and
  /// d beta_i/dx (six and two: M_i counts |p.x| and |p.y| as factors), v the value and g its d/dx:
  ///
  ///     C   = sum M_i (|c_i| + |v e_i|) / |d|
  ///     C_x = (sum X_i (|c_i| + |v e_i|) + C |dd/dx| + |g| sum M_i |e_i|) / |d|
  ///
  /// that is, for kPerspective C = sum M_i (|a_i| + |v|) / |S|, for kLinear the same with M_i |w_i|
  /// and |D|. C_y is C_x with y for x.
  ///
  /// Properties: C >= 2 |v|: C says how large the error of a stable evaluation may be where terms
  ///             cancel, never that it is below the rounding of the value.
  std::optional<ValueAndDerivatives> Conditions(Interpolation interpolation,
                                                const Attribute& a) const;

 private:
  // n / d of the class comment.
  struct Quotient {
    std::array<Rational, 3> c;
    std::array<Rational, 3> e;
    Rational d;
  };
  std::optional<Quotient> QuotientOf(Interpolation interpolation, const Attribute& a) const;
  ValueAndDerivatives DerivativesOf(const Quotient& q) const;
  // Sums of factors times beta_i, d beta_i/dx and d beta_i/dy.
  ValueAndDerivatives Sums(const std::array<Rational, 3>& factors) const;

  HomogeneousTriangle v_;
  std::array<Rational, 2> p_;
  std::array<ValueAndDerivatives, 3> beta_;
  Rational determinant_;
};

/// The distance of neighbours of the format in the binade [2^k, 2^(k+1)) that holds |value|: of the
/// subnormals below the smallest binade, of the largest binade above it.
Rational Ulp(const Rational& value, Precision precision);

/// How far a number may be off: ulps Ulp(value) + absolute + conditions u `condition`, with
/// u = 2^-24 or 2^-53 by the precision.
///
/// Domain:     an error whose parts are finite and not negative.
Rational Allowed(const Rational& value, const Rational& condition, const ValueError& error,
                 Precision precision);

/// Whether |shown - value| <= Allowed(value, condition, error, precision). NaN and infinity never
/// are.
///
/// Error:      none: the decision is that of exact numbers.
bool IsWithin(double shown, const Rational& value, const Rational& condition,
              const ValueError& error, Precision precision);

/// The codes of an unsigned normalized format beside a value: those of c / (2^bits - 1) next to the
/// value clamped to [0, 1].
struct UnormCodes {
  std::uint32_t floor = 0;
  std::uint32_t ceiling = 0;  ///< == floor if the value is that of a code
  int nearer = 0;  ///< -1: floor is nearer, +1: ceiling is, 0: neither, or they are equal

  bool IsNeighbour(std::uint32_t code) const { return code == floor || code == ceiling; }
  /// Of two equally near codes both are.
  bool IsNearest(std::uint32_t code) const {
    return (code == floor && nearer <= 0) || (code == ceiling && nearer >= 0);
  }
};

/// Domain:     1 <= bits <= 32.
UnormCodes ToUnorm(const Rational& value, int bits);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_VALUES_H_
