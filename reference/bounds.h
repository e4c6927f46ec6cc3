// Proven bounds on what every arithmetic of the table makes of E(a, b; p).
#ifndef RASTERPROOF_REFERENCE_BOUNDS_H_
#define RASTERPROOF_REFERENCE_BOUNDS_H_

#include <cstdint>
#include <vector>

#include "core/evaluators.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"

namespace rasterproof::reference {

/// The ways to evaluate E, with fl() for one rounding of the precision, A = fl(b.y - a.y) and
/// B = fl(a.x - b.x). Negating a factor or swapping the factors of a product changes nothing.
enum class EdgeArithmetic : std::uint8_t {
  kDirect,     ///< fl(fl(fl(p.x - a.x) A) - fl(fl(p.y - a.y) fl(b.x - a.x)))
  kDirectFma,  ///< the same with one of the two products fused into the last subtraction
  kKahan,      ///< w = fl(c d); fl(fma(a, b, -w) - fma(c, d, -w)) on the same four differences
  kAffine,     ///< fl(fl(fl(A p.x) + fl(B p.y)) + C), C = fl(fl(b.x a.y) - fl(a.x b.y))
  kAffineFma,  ///< fma(A, p.x, fma(B, p.y, C)), C with one product fused, or not fused at all
  // The rest start from kDirect at the anchor p and differ in how they walk. With D the step's
  // edge difference (A or fl(-dX), negated for a step backwards) and L its length:
  kIncremental,     ///< e = fl(e + fl(L D)) at each step
  kIncrementalRow,  ///< the same along x; a step along y starts afresh (kDirect)
  kIncremental16,   ///< the same; every 16th step starts afresh
  kCompensated,     ///< (e, t) = TwoSum(e, fl(L D)), l = fl(l + t), shown as fl(e + l)
  kIndex,           ///< fl(e_0 + fl(n L D)) after n steps
  kIndexFma         ///< fma(n L, D, e_0) after n steps
};

/// Steps between two fresh starts of kIncremental16.
inline constexpr int kReanchorSteps = 16;

// Every bound is (multiplier) * u * (magnitude), with u = rounding_epsilon<T>(), plus terms of the
// smallest subnormal eta where a product can underflow. S is the sum of the magnitudes of the two
// exact products, |p.x - a.x||b.y - a.y| + |p.y - a.y||b.x - a.x|. Each multiplier is derived from
//   fl(x +- y) = (x +- y)(1 + d),  fl(x y) = x y (1 + d) + e,  |d| <= u,  |e| <= eta / 2
// (a sum never underflows), and the step from the derivation to the number is proved by the named
// script. The limits of the tests are these constants.
//
// The condition: the input is finite, of the precision, and no operation overflows. In coordinates,
// |x| <= kNoOverflowCoordinate suffices for every form; a walk's samples count, too. eta enters as
// 2 eta (direct, fused, Kahan's) or 3 eta (affine) where a product of differences is not a multiple
// of eta: never on a lattice of 2^-74 in float32, 2^-537 in float64.
//
// Where an operation overflows nothing is stated. What comes out then: one product that overflows
// leaves an infinity of E's sign; two of one sign leave NaN (fused: the sign of the rounded one),
// and so does a difference that overflows times 0, whatever E is. NaN is outside by e >= 0, inside
// by !(e < 0), and by its sign bit outside on x86 and inside on Arm. The methods here
// take neither NaN nor an infinity for inside (IsInside). BoundConditions.* tries all of these.

/// The largest power of two up to which every coordinate of a, b and p leaves each intermediate
/// result of each form, and S, at most an eighth of the format's range: 8 (2^k)^2 <= max / 4.
///
/// Properties: at twice as much nothing overflows yet, at four times as much some corners do.
template <class T>
inline constexpr double kNoOverflowCoordinate = sizeof(T) == sizeof(float) ? 0x1p61 : 0x1p509;

/// |direct - E| <= multiplier u S + u |E|.
///
/// A product carries three roundings, (1 + u)^3 - 1 = 3u + 3u^2 + u^3 = r, and the last subtraction
/// one more: (E + r S)(1 + u) - E = r (1 + u) S + u |E|, and r (1 + u) <= (3 + 8u) u.
/// Proof: proofs/edge_direct.g.
/// Measured:   largest error / bound known 0.9997 (f32-direct), 0.9997 (f32-index), 1.0000
///             (f64-direct): scenes/worst/README.md.
template <class T>
inline constexpr double kDirectEdgeErrorMultiplier = 3 + 8.0 * rounding_epsilon<T>();

/// |fused - E| <= multiplier u S + u |E|: the fused product has two roundings, the other one three.
/// Proof: proofs/edge_direct.g.
/// Measured:   0.9983 (f32-direct-fma), as above.
template <class T>
inline constexpr double kDirectFmaEdgeErrorMultiplier = kDirectEdgeErrorMultiplier<T>;

/// |Kahan - E| <= multiplier u S + kKahanEdgeRelError |E|.
///
/// The four differences leave D = ab - cd with |D - E| <= (2u + u^2) S. With w = fl(cd), cd - w is
/// a float, and f = fl(ab - w) is off by u |ab - w| <= u |D| + u^2 |cd|. The last subtraction adds
/// a relative u: |result - D| <= (2u + u^2) |D| + (u^2 + u^3) |cd|. Substituting |D| <= |E| + (2u +
/// u^2) S and |cd| <= (1 + u)^2 S leaves at most (2 + 7u) u S and (2 + u) u |E|. (Jeannerod,
/// Louvet, Muller 2013, Theorem 1.1, show 2u |D| for the last two steps; the difference is second
/// order here. TinyFloats exhausts their 2u for 3 to 6 bits.) 4u: a double next to 2 is a multiple
/// of 4u of float64, and u would be rounded away.
/// Proof: proofs/edge_kahan.g.
/// Measured:   1.0000 (f32-kahan), 1.0000 (f64-kahan), as above.
template <class T>
inline constexpr double kKahanEdgeErrorMultiplier = 2 + 7.0 * rounding_epsilon<T>();
template <class T>
inline constexpr double kKahanEdgeRelError =
    (2 + 4.0 * rounding_epsilon<T>()) * rounding_epsilon<T>();

/// |affine - E| <= u (line multiplier (|dY p.x| + |dX p.y|) + constant multiplier (|b.x a.y| +
/// |a.x b.y|)).
///
/// A p.x carries the rounding of A, of the product and of two sums: (1 + u)^4 - 1 <= (4 + 7u) u;
/// a product of C the product, the difference and one sum: (1 + u)^3 - 1 <= (3 + 4u) u.
/// Fused, no term carries more than A p.x does here: the products of C get one more sum.
/// Proof: proofs/edge_affine.g.
/// Measured:   0.9998 (f32-affine), as above; fused above 0.999: docs/mathematics.md, 9.
template <class T>
inline constexpr double kAffineLineErrorMultiplier = 4 + 7.0 * rounding_epsilon<T>();
template <class T>
inline constexpr double kAffineConstantErrorMultiplier = 3 + 4.0 * rounding_epsilon<T>();
template <class T>
inline constexpr double kAffineFmaLineErrorMultiplier = 3 + 4.0 * rounding_epsilon<T>();
template <class T>
inline constexpr double kAffineFmaConstantErrorMultiplier = 4 + 7.0 * rounding_epsilon<T>();

/// A proven bound on the distance of the arithmetic's value from E(a, b; p).
///
/// Domain:     any; a, b, p are taken as values of the precision.
/// Units:      pixels squared.
/// Returns:    0 where the value is proved exact (every intermediate result fits the significand on
///             the lattice of the coordinates); NaN where none is stated: an input that is not
///             finite or not of the precision, or an intermediate result that might overflow.
/// Error:      rounded up: holds as printed.
/// Measured:   at the constants above; `barycentrics_test --gtest_filter='Bounds*'` prints them.
double EdgeErrorBound(EdgeArithmetic arithmetic, Precision precision, Point2 a, Point2 b, Point2 p);

/// Proven bounds after n = 0..steps steps of a walk from p; entry n bounds |walk[n] - E(p + n
/// step)|.
///
/// Domain:     as EdgeErrorBound; steps >= 0 and step.length >= 1.
/// Returns:    as EdgeErrorBound. NaN also where an arithmetic that starts afresh would have to
///             round the sample's position, and beyond steps * length = 2^p of the precision.
/// Properties: with E exact and D exact, one step adds at most half a unit in the last place of
///             |E|: n steps within one binade drift linearly in n, not as its square root.
///             Proof: proofs/increment.g for one step; the sum is induction.
/// Measured:   largest error / bound known 1.0000 (f32-incremental), 1.0000
///             (f32-incremental-compensated), 1.0000 (f64-incremental): scenes/worst/README.md.
///             kIndexFma 0.997 after 24 steps: BoundsTest, climbing from seed 43, 2026-11-23.
std::vector<double> SteppingErrorBounds(EdgeArithmetic arithmetic, Precision precision, Point2 a,
                                        Point2 b, Point2 p, Step step, int steps);

/// An upper bound on the magnitude of E(a, b; p), within a few ulps of S of it.
///
/// Returns:    infinity or NaN where the differences or products leave the range of double.
double EdgeMagnitudeBound(Point2 a, Point2 b, Point2 p);

/// Rounds a bound up: x was computed in double from at most 64 operations on non-negative terms.
///
/// Each operation is off by at most 2^-53 of the result, 64 of them by less than 2^-46; products
/// that underflowed by less than 64 eta.
double RoundBoundUp(double x);

/// The exponent of the lowest set bit: x is an odd multiple of 2^LatticeExponent(x).
///
/// Domain:     finite.
/// Returns:    kAnyLattice for zero, which is a multiple of everything.
int LatticeExponent(double x);
inline constexpr int kAnyLattice = 1 << 20;

/// A bound on the rounding error of one sum or difference whose exact value is a multiple of
/// 2^lattice and at most `magnitude` in size.
///
/// Returns:    0 if such a value always fits the significand (or is subnormal: sums of floats are
///             exact there); otherwise half a unit in the last place of `magnitude`.
double SumRoundingError(Precision precision, double magnitude, int lattice);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_BOUNDS_H_
