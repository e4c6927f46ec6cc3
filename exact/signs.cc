#include "exact/signs.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/filters.h"
#include "exact/wide_integer.h"

namespace rasterproof::exact {
namespace {

// The sign of a - b if both products are exact enough to decide: rounding is monotone, so different
// roundings decide; equal ones leave the comparison to the residuals a b - fl(a b), which are
// doubles unless they underflow. A residual is a multiple of 2^(e - 105) with 2^e <= |fl(a b)|, so
// a product of at least 2^-969 has one.
constexpr double kMinProductNoUnderflow = 0x1p-969;

std::optional<int> StableProductDifferenceSign(double a, double b, double c, double d) {
  const double p = a * b;
  const double q = c * d;
  if (p > q) return 1;
  if (p < q) return -1;
  if (p == 0) {
    const bool both_zero = (a == 0 || b == 0) && (c == 0 || d == 0);
    return both_zero ? std::optional<int>(0) : std::nullopt;
  }
  const double magnitude = std::fabs(p);
  if (!(magnitude >= kMinProductNoUnderflow && magnitude <= std::numeric_limits<double>::max())) {
    return std::nullopt;
  }
  const double p_residual = std::fma(a, b, -p);
  const double q_residual = std::fma(c, d, -q);
  return (p_residual > q_residual) - (p_residual < q_residual);
}

// Whether fl(a - b) == a - b, given difference = fl(a - b): Knuth's residual, itself exact unless
// something overflows, and then it is not zero but NaN or infinite.
bool IsExactDifference(double a, double b, double difference) {
  const double b_seen = a - difference;
  const double a_seen = difference + b_seen;
  return (a - a_seen) + (b_seen - b) == 0;
}

int ExactEdgeSign(Point2 a, Point2 b, Point2 p) {
  // Each product takes one factor from x and one from y, so each axis may have its own unit.
  const int ux = CommonUnit({a.x, b.x, p.x});
  const int uy = CommonUnit({a.y, b.y, p.y});
  const WideInteger ax(a.x, ux);
  const WideInteger ay(a.y, uy);
  const WideInteger l = (WideInteger(p.x, ux) - ax) * (WideInteger(b.y, uy) - ay);
  const WideInteger r = (WideInteger(p.y, uy) - ay) * (WideInteger(b.x, ux) - ax);
  return Compare(l, r);
}

int ExactDeterminantSign(const Rows3& m) {
  // Scaling a column scales the determinant, so each column may have its own unit.
  std::array<int, 3> unit{};
  for (unsigned k = 0; k < 3; ++k) unit[k] = CommonUnit({m[0][k], m[1][k], m[2][k]});
  const auto at = [&](unsigned i, unsigned k) { return WideInteger(m[i][k], unit[k]); };
  const auto minor = [&](unsigned j, unsigned k) {
    return at(1, j) * at(2, k) - at(1, k) * at(2, j);
  };
  return (at(0, 0) * minor(1, 2) - at(0, 1) * minor(0, 2) + at(0, 2) * minor(0, 1)).Sign();
}

}  // namespace

TierCounts& ThreadTiers() {
  thread_local TierCounts counts;
  return counts;
}

TieredSign FastEdgeSign(Point2 a, Point2 b, Point2 p) {
  const EdgeProducts e(a, b, p);
  const int sign = e.Filter().CertainSign();
  if (sign != 0) [[likely]] {
    return {sign, &TierCounts::filter};
  }
  if (IsExactDifference(p.x, a.x, e.px) && IsExactDifference(p.y, a.y, e.py) &&
      IsExactDifference(b.x, a.x, e.dx) && IsExactDifference(b.y, a.y, e.dy)) {
    const std::optional<int> stable = StableProductDifferenceSign(e.px, e.dy, e.py, e.dx);
    if (stable) return {*stable, &TierCounts::stable};
  }
  return {ExactEdgeSign(a, b, p), &TierCounts::exact};
}

TieredSign FastDeterminantSign(const Rows3& m) {
  const int sign = FilterDeterminant(m).CertainSign();
  if (sign != 0) [[likely]] {
    return {sign, &TierCounts::filter};
  }
  return {ExactDeterminantSign(m), &TierCounts::exact};
}

int ProductDifferenceSign(double a, double b, double c, double d) {
  const std::optional<int> stable = StableProductDifferenceSign(a, b, c, d);
  if (stable) return *stable;
  // The units of a and of b divide out of the comparison only if both products carry them.
  const int first = CommonUnit({a, c, 0});
  const int second = CommonUnit({b, d, 0});
  return Compare(WideInteger(a, first) * WideInteger(b, second),
                 WideInteger(c, first) * WideInteger(d, second));
}

}  // namespace rasterproof::exact
