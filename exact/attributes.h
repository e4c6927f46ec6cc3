// Exact barycentrics, interpolated values and wireframe distances, as rationals and correctly
// rounded.
#ifndef RASTERPROOF_EXACT_ATTRIBUTES_H_
#define RASTERPROOF_EXACT_ATTRIBUTES_H_

#include <array>
#include <optional>

#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::exact {

/// lambda_i = E(edge opposite v_i; p) / E(v0, v1; v2). They sum to one, signed, at every p.
///
/// Returns:    nothing if the area is zero.
std::optional<std::array<Rational, 3>> Barycentrics(const std::array<Point2, 3>& v, Point2 p);

/// lambda_0 z_0 + lambda_1 z_1 + lambda_2 z_2; nothing if the area is zero.
std::optional<Rational> Interpolate(const std::array<Point2, 3>& v,
                                    const std::array<double, 3>& attribute, Point2 p);

/// (sum lambda_i z_i / w_i) / (sum lambda_i / w_i) with the screen-space lambda; nothing if the
/// area, a w or the denominator is zero.
std::optional<Rational> InterpolatePerspective(const std::array<Point2, 3>& v,
                                               const std::array<double, 3>& w,
                                               const std::array<double, 3>& attribute, Point2 p);

/// Squared distance of p from the line through a and b, in pixels squared; nothing if a == b.
std::optional<Rational> SquaredLineDistance(Point2 a, Point2 b, Point2 p);

/// The square root of a non-negative rational, rounded to nearest (by comparing squares).
double NearestSquareRoot(const Rational& square);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_ATTRIBUTES_H_
