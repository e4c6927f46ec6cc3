// A floating-point number that carries a proven bound on its own error.
#ifndef RASTERPROOF_REFERENCE_RUNNING_ERROR_H_
#define RASTERPROOF_REFERENCE_RUNNING_ERROR_H_

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene.h"
#include "reference/bounds.h"

namespace rasterproof::reference {

/// The computed value of T beside a bound on its distance from the exact one: running error
/// analysis (Wilkinson 1963; Higham 2002, section 3.3). An expression that is a template of its
/// number type gives its value with T and its bound with RunningError<T>.
///
/// Returns:    error is NaN, and stays so, once a value is not finite or a divisor may be 0.
template <class T>
struct RunningError {
  T value = 0;
  double error = 0;

  static constexpr Precision kPrecision =
      sizeof(T) == sizeof(float) ? Precision::kFloat32 : Precision::kFloat64;
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  /// No lattice is known: half an ulp is all that can be said of a rounding.
  static constexpr int kNoLattice = -(1 << 20);

  RunningError() = default;
  RunningError(T exact) : value(exact) {}  // NOLINT(google-explicit-constructor): a T is exact
  RunningError(T computed, double bound) : value(computed), error(bound) {}

  bool IsExactZero() const { return value == 0 && error == 0; }
  double Magnitude() const { return std::fabs(static_cast<double>(value)); }

  /// x - y of two exact values, on the lattice that both lie on.
  static RunningError Difference(T x, T y) {
    const T d = x - y;
    const int lattice = std::min(LatticeExponent(x), LatticeExponent(y));
    if (!std::isfinite(d)) return {d, kNone};
    return {d, SumRoundingError(kPrecision, std::fabs(static_cast<double>(d)), lattice)};
  }

  /// The result of one operation: the operands' errors, grown, and half an ulp of the result.
  /// `may_underflow`: products and quotients lose up to eta / 2 more below the normal range.
  static RunningError Rounded(T value, double propagated, bool may_underflow) {
    if (!std::isfinite(value)) return {value, kNone};
    const double m = std::fabs(static_cast<double>(value));
    double rounding = SumRoundingError(kPrecision, m, kNoLattice);
    if (may_underflow && m <= std::numeric_limits<T>::min()) {
      rounding = static_cast<double>(std::numeric_limits<T>::denorm_min());
    }
    return {value, RoundBoundUp(propagated + rounding)};
  }

  RunningError operator-() const { return {-value, error}; }
  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    return Rounded(a.value + b.value, a.error + b.error, false);
  }
  friend RunningError operator-(const RunningError& a, const RunningError& b) { return a + -b; }
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    if (a.IsExactZero() || b.IsExactZero()) return {a.value * b.value, 0};
    return Rounded(a.value * b.value,
                   a.Magnitude() * b.error + b.Magnitude() * a.error + a.error * b.error, true);
  }
  friend RunningError operator/(const RunningError& a, const RunningError& b) {
    return Rounded(a.value / b.value, QuotientError(a, b), true);
  }

  /// A bound on |a'/b' - a/b|, the quotient of the computed values not yet rounded.
  ///
  /// a'/b' - a/b = (a' - a - (a/b)(b' - b)) / b', and |a/b| <= (|a'| + ea) / (|b'| - eb).
  static double QuotientError(const RunningError& a, const RunningError& b) {
    const double divisor = (b.Magnitude() - b.error) * (1 - 0x1p-50);
    if (!(divisor > 0)) return kNone;
    if (a.IsExactZero()) return 0;
    const double quotient = (a.Magnitude() + a.error) / divisor;
    return RoundBoundUp((a.error + quotient * b.error) / b.Magnitude());
  }
};

/// | |x'| - |x| | <= |x' - x|.
template <class T>
RunningError<T> Abs(const RunningError<T>& x) {
  return {std::fabs(x.value), x.error};
}
inline float Abs(float x) { return std::fabs(x); }
inline double Abs(double x) { return std::fabs(x); }

/// sqrt(x') - sqrt(x) = (x' - x) / (sqrt(x') + sqrt(x)); fl(sqrt) is within u of sqrt(x').
template <class T>
RunningError<T> Sqrt(const RunningError<T>& x) {
  const T root = std::sqrt(x.value);
  if (!(root > 0)) return {root, RunningError<T>::kNone};
  const double lower = static_cast<double>(root) * (1 - 0x1p-22);
  return RunningError<T>::Rounded(root, x.error / lower, false);
}
inline float Sqrt(float x) { return std::sqrt(x); }
inline double Sqrt(double x) { return std::sqrt(x); }

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_RUNNING_ERROR_H_
