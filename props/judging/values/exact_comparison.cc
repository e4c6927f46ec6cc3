#include "props/judging/values/exact_comparison.h"

#include <cmath>
#include <limits>
#include <optional>

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

Distance CompareWithExact(double observed, const Rational& exact, const Rational& bound) {
  if (!std::isfinite(observed)) return {false, kInfinity};
  const Rational distance = (Rational(observed) - exact).Abs();
  if (distance.Sign() == 0) return {true, 0};
  if (bound.Sign() == 0) return {false, kInfinity};
  return {distance <= bound, (distance / bound).ToDouble()};
}

std::optional<Distance> CompareWithEstimate(double observed, const Estimate& estimate,
                                            double bound) {
  // What the pair of the estimate leaves of the observed value takes two roundings.
  const Pair rest = TwoSum(observed, -estimate.high());
  const double low = rest.low - estimate.low();
  const double distance = std::fabs(rest.high + low);
  const double slack =
      estimate.error() + 2 * rounding_epsilon<double>() * (distance + std::fabs(low));
  if (!(distance + slack <= bound * (1 - 4 * rounding_epsilon<double>()))) return std::nullopt;
  return Distance{true, distance == 0 ? 0 : distance / bound};
}

Distance CompareWithEdge(double observed, Point2 a, Point2 b, Point2 p, double bound) {
  if (!std::isfinite(observed)) return {false, kInfinity};
  if (IsExactly(observed, a, b, p)) return {true, 0};
  if (const auto near = CompareWithEstimate(observed, EstimatedEdge(a, b, p), bound)) return *near;
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
