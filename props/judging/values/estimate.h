// Numbers of about 100 bits with a bound on what they miss: they decide what is far from its bound,
// so that exact rationals are asked for only beside it.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_ESTIMATE_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_ESTIMATE_H_

#include <array>
#include <cmath>
#include <limits>

#include "core/vertex.h"

namespace rasterproof::props {

/// A real number within `error` of the unevaluated sum high + low, where |low| <= ulp(high) / 2.
///
/// A sum's error is what its own roundings lost, in full; so sums, and products and quotients that
/// are doubles, can be exact. Others are DWTimesDW2 and DWDivDW2 of Joldes, Muller and Popescu
/// (Tight and rigorous error bounds for basic building blocks of double-word arithmetic, TOMS
/// 2017): without underflow their relative errors are below 6 and 16 times 2^-106, and 2^-100
/// bounds both. Products and quotients below 2^-900 could lose bits to underflow, and have an
/// infinite error, as have those above 2^900. Sums don't underflow. A bound is a sum of products of
/// non-negative doubles: its own roundings are below a factor 1 + 2^-40, its underflows below
/// 2^-1000. What overflows is infinite or NaN, and so is its error: it decides nothing.
///
/// Largest error over its bound, as estimate_test prints it: sums 1.0000, products 0.0420,
/// quotients 0.0691.
class Estimate {
 public:
  Estimate() = default;
  explicit Estimate(double x) : high_(x) {}
  /// x - y, exactly.
  static Estimate Difference(double x, double y) { return {Sum(x, -y), 0}; }

  double high() const { return high_; }
  double low() const { return low_; }
  double error() const { return error_; }

  Estimate operator-() const { return {{-high_, -low_}, error_}; }
  Estimate Abs() const { return high_ < 0 ? -*this : *this; }

  // Every pair below is exact: only the two lows that are left out are lost.
  friend Estimate operator+(const Estimate& x, const Estimate& y) {
    const Pair leading = Sum(x.high_, y.high_);
    const Pair trailing = Sum(x.low_, y.low_);
    const Pair middle = Sum(leading.low, trailing.high);
    const Pair first = Sum(leading.high, middle.high);
    const Pair last = Sum(trailing.low, first.low);
    const double lost = std::fabs(middle.low) + std::fabs(last.low);
    return Estimate(Sum(first.high, last.high), Grown(x.error_ + y.error_ + lost));
  }
  friend Estimate operator-(const Estimate& x, const Estimate& y) { return x + -y; }

  friend Estimate operator*(const Estimate& x, const Estimate& y) {
    const Pair leading = Product(x.high_, y.high_);
    if (x.IsZero() || y.IsZero()) return {{leading.high, 0}, 0 * (x.error_ + y.error_)};
    if (x.IsDouble() && y.IsDouble() && InRange(leading.high)) return {leading, 0};
    const double cross = std::fma(x.low_, y.high_, x.high_ * y.low_);
    const double carried =
        std::fabs(x.high_) * y.error_ + (std::fabs(y.high_) + y.error_) * x.error_ + kUnderflow;
    const Pair product = Sum(leading.high, leading.low + cross);
    const bool around_zero = x.high_ == 0 || y.high_ == 0;
    return {product, around_zero ? Grown(carried) : Rounded(product.high, carried)};
  }

  /// Error:      infinite unless y is at least 2^20 times its own error.
  friend Estimate operator/(const Estimate& x, const Estimate& y) {
    const double divisor = std::fabs(y.high_);
    if (!InRange(divisor) || !(y.error_ <= 0x1p-20 * divisor)) return {{0, 0}, kInfinite};
    if (x.IsZero()) return {};
    const double quotient = x.high_ / y.high_;
    const Pair back = TimesDouble(y, quotient);
    const double rest = ((x.high_ - back.high) + (x.low_ - back.low)) / y.high_;
    const bool in_range = x.high_ == 0 || (InRange(x.high_) && InRange(quotient));
    if (in_range && x.IsDouble() && y.IsDouble() && rest == 0) return Estimate(quotient);
    const Pair value = Sum(quotient, rest);
    const double carried =
        (x.error_ + std::fabs(value.high) * y.error_) / (divisor - y.error_) + kUnderflow;
    if (x.high_ == 0) return {{0, 0}, Grown(carried)};
    return {value, in_range ? Rounded(value.high, carried) : kInfinite};
  }

 private:
  struct Pair {
    double high;
    double low;
  };

  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static constexpr double kRelError = 0x1p-100;
  static constexpr double kUnderflow = 0x1p-1000;

  Estimate(Pair value, double error) : high_(value.high), low_(value.low), error_(error) {}

  bool IsZero() const { return high_ == 0 && error_ == 0; }
  bool IsDouble() const { return low_ == 0 && error_ == 0; }
  static bool InRange(double x) { return std::fabs(x) >= 0x1p-900 && std::fabs(x) <= 0x1p900; }
  static double Grown(double error) { return error * (1 + 0x1p-40); }
  static double Rounded(double value, double carried) {
    return InRange(value) ? Grown(carried + kRelError * std::fabs(value)) : kInfinite;
  }

  // Knuth's TwoSum: exact unless it overflows.
  static Pair Sum(double x, double y) {
    const double sum = x + y;
    const double from_y = sum - x;
    return {sum, (x - (sum - from_y)) + (y - from_y)};
  }
  static Pair Product(double x, double y) {
    const double product = x * y;
    return {product, std::fma(x, y, -product)};
  }
  static Pair TimesDouble(const Estimate& x, double y) {
    const Pair leading = Product(x.high_, y);
    const Pair sum = Sum(leading.high, x.low_ * y);
    return Sum(sum.high, sum.low + leading.low);
  }

  double high_ = 0;
  double low_ = 0;
  double error_ = 0;
};

/// E(a, b; p).
inline Estimate EstimatedEdge(Point2 a, Point2 b, Point2 p) {
  return Estimate::Difference(p.x, a.x) * Estimate::Difference(b.y, a.y) -
         Estimate::Difference(p.y, a.y) * Estimate::Difference(b.x, a.x);
}

/// The three lambda_i at p.
inline std::array<Estimate, 3> EstimatedBarycentrics(const std::array<Point2, 3>& v, Point2 p) {
  const Estimate area = EstimatedEdge(v[0], v[1], v[2]);
  return {EstimatedEdge(v[1], v[2], p) / area, EstimatedEdge(v[2], v[0], p) / area,
          EstimatedEdge(v[0], v[1], p) / area};
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_ESTIMATE_H_
