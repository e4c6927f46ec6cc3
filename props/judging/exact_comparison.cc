#include "props/judging/exact_comparison.h"

#include <cmath>
#include <limits>

#include "core/ulp.h"
#include "exact/edge.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An unevaluated sum high + low with |low| <= ulp(high) / 2.
struct Pair {
  double high;
  double low;
};

// Knuth's TwoSum: exact unless it overflows.
Pair TwoSum(double x, double y) {
  const double sum = x + y;
  const double from_y = sum - x;
  return {sum, (x - (sum - from_y)) + (y - from_y)};
}

Pair TwoProduct(double x, double y) {
  const double product = x * y;
  return {product, std::fma(x, y, -product)};
}

// (x.high + x.low)(y.high + y.low) without the product of the low parts: relative error below
// 4 * 2^-106, the sum of one dropped term (2^-106) and three roundings of terms below 2^-52.
Pair Product(const Pair& x, const Pair& y) {
  const Pair leading = TwoProduct(x.high, y.high);
  const double cross = x.high * y.low + x.low * y.high;
  return TwoSum(leading.high, leading.low + cross);
}

// E(a, b; p) as a pair, with a bound on what the pair misses.
struct EdgeEstimate {
  Pair value;
  double error;
  bool usable;
};

// Both products carry a relative error below 2^-102 (Product, and TwoSum's second rounding), and
// the final sum one below 2^-104 of either: 2^-98 S is generous. Products below 2^-900 could lose
// bits to underflow, above 2^900 to overflow; then the estimate is not used.
constexpr double kEdgeEstimateRelError = 0x1p-98;
constexpr double kLeastProductSum = 0x1p-850;
constexpr double kLargestProductSum = 0x1p900;

EdgeEstimate EstimateEdge(Point2 a, Point2 b, Point2 p) {
  const Pair first = Product(TwoSum(p.x, -a.x), TwoSum(b.y, -a.y));
  const Pair second = Product(TwoSum(p.y, -a.y), TwoSum(b.x, -a.x));
  const double size = std::fabs(first.high) + std::fabs(second.high);
  const Pair leading = TwoSum(first.high, -second.high);
  const Pair trailing = TwoSum(first.low, -second.low);
  const Pair value = TwoSum(leading.high, leading.low + trailing.high);
  const bool usable = size >= kLeastProductSum && size <= kLargestProductSum;
  return {value, kEdgeEstimateRelError * size, usable};
}

// With differences and products that lost nothing, E itself is first - second.
bool IsExactly(double observed, Point2 a, Point2 b, Point2 p) {
  const Pair px = TwoSum(p.x, -a.x);
  const Pair py = TwoSum(p.y, -a.y);
  const Pair dx = TwoSum(b.x, -a.x);
  const Pair dy = TwoSum(b.y, -a.y);
  if (px.low != 0 || py.low != 0 || dx.low != 0 || dy.low != 0) return false;
  const Pair first = TwoProduct(px.high, dy.high);
  const Pair second = TwoProduct(py.high, dx.high);
  // fma's residual is exact only if the product is far above the subnormals, or an exact zero.
  const auto lossless = [](const Pair& product, double x, double y) {
    return product.low == 0 && (std::fabs(product.high) >= 0x1p-900 || x == 0 || y == 0);
  };
  if (!lossless(first, px.high, dy.high) || !lossless(second, py.high, dx.high)) return false;
  const Pair difference = TwoSum(first.high, -second.high);
  return difference.low == 0 && difference.high == observed;
}

}  // namespace

Distance CompareWithExact(double observed, const Rational& exact, double bound) {
  if (!std::isfinite(observed)) return {false, kInfinity};
  const Rational distance = (Rational(observed) - exact).Abs();
  if (distance.Sign() == 0) return {true, 0};
  if (bound == 0) return {false, kInfinity};
  return {distance <= Rational(bound), (distance / Rational(bound)).ToDouble()};
}

Distance CompareWithEdge(double observed, Point2 a, Point2 b, Point2 p, double bound) {
  if (!std::isfinite(observed)) return {false, kInfinity};
  if (IsExactly(observed, a, b, p)) return {true, 0};
  const EdgeEstimate estimate = EstimateEdge(a, b, p);
  if (estimate.usable && bound > 0) {
    // Two roundings, each within 2^-53 of a value that the first one bounds.
    const double distance = std::fabs((observed - estimate.value.high) - estimate.value.low);
    const double slack = estimate.error + 4 * rounding_epsilon<double>() * distance +
                         2 * rounding_epsilon<double>() * std::fabs(estimate.value.low);
    if (distance + slack <= bound * (1 - 4 * rounding_epsilon<double>())) {
      return {true, distance / bound};
    }
  }
  return CompareWithExact(observed, exact::EdgeValue(a, b, p), bound);
}

bool AgreeWithin(double x, double y, int sign, double bound_x, double bound_y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return false;
  const double signed_y = sign < 0 ? -y : y;
  if (x == -signed_y) return true;
  const double sum = std::fabs(x + signed_y);
  if (sum <= (bound_x + bound_y) * (1 - 4 * rounding_epsilon<double>())) return true;
  return (Rational(x) + Rational(signed_y)).Abs() <= Rational(bound_x) + Rational(bound_y);
}

bool HasSign(double x, int sign) {
  if (std::isnan(x)) return false;
  return (x > 0) - (x < 0) == sign;
}

bool IsStated(double bound) { return std::isfinite(bound) && bound >= 0; }

}  // namespace rasterproof::props
