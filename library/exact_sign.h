// Exact signs of edge functions, by tiers: filter, stable, exact.
#ifndef RASTERPROOF_LIBRARY_EXACT_SIGN_H_
#define RASTERPROOF_LIBRARY_EXACT_SIGN_H_

#include <cmath>

#include "core/ulp.h"
#include "core/vertex.h"
#include "library/exact_sum.h"

namespace rasterproof::library {

/// |(p1 - p2) - E| <= kFilterErrorMultiplier * fl(|p1| + |p2|) + kFilterUnderflowError, p1 and p2
/// the rounded products of the direct form in double, whatever the finite coordinates; and where
/// |fl(p1 - p2)| is larger than that, it has E's sign.
///
/// Each product carries three roundings, so |p1 - p1'| <= (3u + 3u^2 + u^3) |p1'| against its exact
/// value p1', or (3u + 6u^2 + ...) |p1| against the computed one. A sign needs only |p1 - p2| > the
/// products' error, and fl(p1 - p2) and fl(|p1| + |p2|) are each off by a relative u: (3 + 16u) u
/// covers them, as in Shewchuk's orient2d (Discrete Comput. Geom. 18, 1997, section 4.3), whose
/// condition this is. It does not bound |fl(p1 - p2) - E|, which the last rounding adds to.
/// A product that underflows is off by 2^-1075 more; two of them by 2^-1074, and the rounding of
/// the right-hand side itself by less than as much again. Overflow leaves infinity or NaN on the
/// right, and the comparison false.
/// Proof: reference/proofs/edge_filter.g.
/// Measured:   largest |(p1 - p2) - E| / bound known above 0.999 (docs/mathematics.md, 9, has the
///             witness), 0.250 where products underflow: MeasuredReferenceBounds, 10000 inputs
///             climbing from seed 72, 2026-11-23.
inline constexpr double kFilterErrorMultiplier =
    (3 + 16 * rounding_epsilon<double>()) * rounding_epsilon<double>();
inline constexpr double kFilterUnderflowError = 0x1p-1072;

/// Filter tier: the direct form in double, and whether its sign is proved. Templates of the number
/// type: tests run them with one that writes down its roundings, which brings its own fabs.
struct FilteredEdge {
  double value;
  bool certain;
};
/// The two rounded products of the direct form, E = p1 - p2.
template <class T>
struct DirectProducts {
  T p1, p2;

  /// `Point` has an x and a y of T.
  template <class Point>
  DirectProducts(const Point& a, const Point& b, const Point& p)
      : p1((p.x - a.x) * (b.y - a.y)), p2((p.y - a.y) * (b.x - a.x)) {}
};
template <class T>
T FilterBound(const T& p1, const T& p2) {
  using std::fabs;
  return kFilterErrorMultiplier * (fabs(p1) + fabs(p2)) + kFilterUnderflowError;
}
inline FilteredEdge FilterEdge(Point2 a, Point2 b, Point2 p) {
  const DirectProducts<double> products(a, b, p);
  const double e = products.p1 - products.p2;
  return {e, std::fabs(e) > FilterBound(products.p1, products.p2)};
}

/// Stable, then exact tier: the sign of E(a, b; p) where the filter could not tell.
///
/// Domain:     every finite double.
/// Error:      none.
int UnfilteredEdgeSign(Point2 a, Point2 b, Point2 p);

/// The sign of E(a, b; p): +1 if a, b, p turn counter-clockwise on screen, -1 clockwise, 0
/// collinear.
///
/// Domain:     every finite double.
/// Error:      none.
/// Cost:       filter 10 operations, magnitudes and a comparison apart; stable 26 more and two fma;
///             exact six products in sums of 66 words.
inline int EdgeSign(Point2 a, Point2 b, Point2 p) {
  const FilteredEdge e = FilterEdge(a, b, p);
  if (e.certain) return e.value > 0 ? 1 : -1;
  return UnfilteredEdgeSign(a, b, p);
}

/// E(a, b; p) as an exact sum.
ExactSum ExactEdge(Point2 a, Point2 b, Point2 p);

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_EXACT_SIGN_H_
