// The filter tier: values in double, and the magnitude beyond which their signs are certain.
//
// Templates of the number type: tests run them with one that writes down its roundings, which
// brings its own fabs.
#ifndef RASTERPROOF_EXACT_FILTERS_H_
#define RASTERPROOF_EXACT_FILTERS_H_

#include <array>
#include <cmath>

#include "core/ulp.h"
#include "core/vertex.h"

namespace rasterproof::exact {

/// A value and its error. If |value| exceeds the error, its sign is the exact one's.
template <class T>
struct FilteredValueOf {
  T value = 0;
  T error = 0;

  /// The sign where it is certain, otherwise 0. Overflow leaves an infinite or NaN error: 0.
  int CertainSign() const { return (value > error) - (value < -error); }
};
using FilteredValue = FilteredValueOf<double>;

/// Filter for E = l - r, l = fl(fl(x-X) fl(Y'-Y)), r likewise, d = fl(l - r).
///
/// Without underflow each of l and r carries three roundings: |E - (l - r)| <= ((1 + u)^3 - 1)
/// times the sum of their exact magnitudes, (3 u + 6 u^2 + ...) (|l| + |r|). With
/// m = fl(|l| + |r|) >= (|l| + |r|) (1 - u) and |d| <= |l - r| (1 + u), d has E's sign if
/// |d| > (3 u + 12 u^2 + ...) m, and fl(multiplier m) is at least (3 u + 13 u^2 - ...) m: the
/// multiplier, of Shewchuk's orient2d (1997, stage A), covers the roundings of the test. It bounds
/// |E - (l - r)|, not |E - d|: the last rounding cannot change the sign and is not in it.
/// Proof:      reference/proofs/edge_filter.g.
/// Measured:   largest |E - (l - r)| / bound known above 0.999: docs/mathematics.md, 9, has the
///             witness.
inline constexpr double kEdgeErrorMultiplier =
    (3 + 16 * rounding_epsilon<double>()) * rounding_epsilon<double>();
/// A product that underflows is off by at most 2^-1075 more, and so is the product of the
/// multiplier: three such errors are below 2^-1072. Where the sum with that constant rounds,
/// m >= 2^-970: at most one product can have underflowed, and the other one, 2^50 times as large at
/// least, gives both d and E their sign.
/// Measured:   0.250, where all products underflow: MeasuredBounds, 30000 inputs climbing from seed
///             62, 2026-11-23.
inline constexpr double kEdgeUnderflowError = 0x1p-1072;

/// The value and the error of the two rounded products of an edge.
template <class T>
FilteredValueOf<T> FilterProducts(const T& l, const T& r) {
  using std::fabs;
  return {l - r, kEdgeErrorMultiplier * (fabs(l) + fabs(r)) + kEdgeUnderflowError};
}

/// The differences and products of E(a, b; p).
template <class T>
struct EdgeProductsOf {
  T px, py, dx, dy;
  T l, r;

  /// `Point` has an x and a y of T.
  template <class Point>
  EdgeProductsOf(const Point& a, const Point& b, const Point& p)
      : px(p.x - a.x), py(p.y - a.y), dx(b.x - a.x), dy(b.y - a.y), l(px * dy), r(py * dx) {}

  FilteredValueOf<T> Filter() const { return FilterProducts(l, r); }
};
using EdgeProducts = EdgeProductsOf<double>;

/// Filter for a 3x3 determinant by minors of the last two rows.
///
/// Per term a (e i - f h): two roundings (product, difference) in the minor, one in the product
/// with a, two in the sum of three terms: five, each relative to the permanent a (|e i| + |f h|).
/// The permanent itself is computed low by up to five roundings, the product with the multiplier
/// by one. (1 + u)^5 - 1 <= 5.01 u and (1 + u)^6 cover that: 8 leaves 2.9 u spare.
/// Proof:      reference/proofs/determinant_filter.g.
/// Measured:   largest error / bound known 0.625, the 5u of the value: as above.
inline constexpr double kDeterminantErrorMultiplier = 8 * rounding_epsilon<double>();
/// An underflow inside a minor, at most 2 * 2^-1075, is multiplied by the first row's factor: grown
/// by the roundings, 2^-1073 |a|. Those of the three outer products, 3 * 2^-1075, and of the two
/// products of the bound, 2 * 2^-1075, are below kEdgeUnderflowError. Where its sum with the other
/// terms rounds, the multiplier's spare 2.9 u holds them.
/// Measured:   0.170 where minors underflow, 0.371 where terms do: MeasuredBounds, 30000
///             inputs each, seeds 64 and 65, 2026-11-23.
inline constexpr double kMinorUnderflowError = 0x1p-1072;

template <class T>
using Rows3Of = std::array<std::array<T, 3>, 3>;
using Rows3 = Rows3Of<double>;

template <class T>
FilteredValueOf<T> FilterDeterminant(const Rows3Of<T>& m) {
  using std::fabs;
  T sum = 0;
  T permanent = 0;
  T first_row = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned i = (k + 1) % 3;
    const unsigned j = (k + 2) % 3;
    const T l = m[1][i] * m[2][j];
    const T r = m[1][j] * m[2][i];
    sum = sum + m[0][k] * (l - r);
    permanent = permanent + fabs(m[0][k]) * (fabs(l) + fabs(r));
    first_row = first_row + fabs(m[0][k]);
  }
  return {sum, kDeterminantErrorMultiplier * permanent + kMinorUnderflowError * first_row +
                   kEdgeUnderflowError};
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_FILTERS_H_
