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
  const Estimate rest = Estimate::Difference(observed, estimate.high());
  const double low = rest.low() - estimate.low();
  const double distance = std::fabs(rest.high() + low);
  const double slack =
      estimate.error() + 2 * rounding_epsilon<double>() * (distance + std::fabs(low));
  if (!(distance + slack <= bound * (1 - 4 * rounding_epsilon<double>()))) return std::nullopt;
  return Distance{true, distance == 0 ? 0 : distance / bound};
}

Distance CompareWithEdge(double observed, Point2 a, Point2 b, Point2 p, double bound) {
  if (!std::isfinite(observed)) return {false, kInfinity};
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
