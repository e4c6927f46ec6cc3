#include "exact/signs.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/wide_integer.h"

namespace rasterproof::exact {
namespace {

constexpr double kU = rounding_epsilon<double>();

// Filter for E = l - r, l = fl(fl(x-X) fl(Y'-Y)), r likewise, d = fl(l - r).
//
// Without underflow each of l and r carries three roundings: |E - (l - r)| <= ((1 + u)^3 - 1)
// (|l| + |r|). With m = fl(|l| + |r|) >= (|l| + |r|) (1 - u) and |d| <= |l - r| (1 + u), d has E's
// sign if |d| > (3 u + 9 u^2 + ...) m, and fl(multiplier m) is at least (3 u + 13 u^2 - ...) m: the
// multiplier, of Shewchuk's orient2d (1997, stage A), covers the roundings of the test and leaves
// 4 u^2 m. A sum of doubles never underflows inexactly; a product that underflows is off by at most
// 2^-1075 more, and so is the product of the multiplier: three such errors are below 2^-1072. Where
// the sum with that constant rounds, m >= 2^-970, only one product can have underflowed, and the
// 4 u^2 m >= 2^-1074 hold its error. Overflow makes the bound infinite or NaN, and both comparisons
// fail: undecided.
constexpr double kEdgeErrorMultiplier = (3 + 16 * kU) * kU;
constexpr double kEdgeUnderflowError = 0x1p-1072;

// Filter for a 3x3 determinant by minors of the last two rows. Per term a (e i - f h): two
// roundings (product, difference) in the minor, one in the product with a, two in the sum of three
// terms: five, each relative to the permanent a (|e i| + |f h|). The permanent itself is computed
// low by up to five roundings, the product with the multiplier by one. (1 + u)^5 - 1 <= 5.01 u and
// (1 + u)^6 cover that: 8 leaves 2.9 u spare.
constexpr double kDeterminantErrorMultiplier = 8 * kU;
// An underflow inside a minor, at most 2 * 2^-1075, is multiplied by the first row's factor: grown
// by the roundings, 2^-1073 |a|. Those of the three outer products, 3 * 2^-1075, and of the two
// products of the bound, 2 * 2^-1075, are below kEdgeUnderflowError. Where its sum with the other
// terms rounds, the multiplier's spare 2.9 u holds them.
constexpr double kMinorUnderflowError = 0x1p-1072;

int Certain(double d, double error) { return (d > error) - (d < -error); }

// The sign of a - b if both products are exact enough to tell: rounding is monotone, so different
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
  // Each product takes one factor from x and one from y, so the axes may have units of their own.
  const int ux = CommonUnit({a.x, b.x, p.x});
  const int uy = CommonUnit({a.y, b.y, p.y});
  const WideInteger ax(a.x, ux);
  const WideInteger ay(a.y, uy);
  const WideInteger l = (WideInteger(p.x, ux) - ax) * (WideInteger(b.y, uy) - ay);
  const WideInteger r = (WideInteger(p.y, uy) - ay) * (WideInteger(b.x, ux) - ax);
  return Compare(l, r);
}

int ExactDeterminantSign(const Rows3& m) {
  // Scaling a column scales the determinant: each column has a unit of its own.
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
  const double px = p.x - a.x;
  const double py = p.y - a.y;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double l = px * dy;
  const double r = py * dx;
  const double error = kEdgeErrorMultiplier * (std::fabs(l) + std::fabs(r)) + kEdgeUnderflowError;
  const int sign = Certain(l - r, error);
  if (sign != 0) [[likely]] {
    return {sign, &TierCounts::filter};
  }
  if (IsExactDifference(p.x, a.x, px) && IsExactDifference(p.y, a.y, py) &&
      IsExactDifference(b.x, a.x, dx) && IsExactDifference(b.y, a.y, dy)) {
    const std::optional<int> stable = StableProductDifferenceSign(px, dy, py, dx);
    if (stable) return {*stable, &TierCounts::stable};
  }
  return {ExactEdgeSign(a, b, p), &TierCounts::exact};
}

TieredSign FastDeterminantSign(const Rows3& m) {
  double sum = 0;
  double permanent = 0;
  double first_row = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned i = (k + 1) % 3;
    const unsigned j = (k + 2) % 3;
    const double l = m[1][i] * m[2][j];
    const double r = m[1][j] * m[2][i];
    sum += m[0][k] * (l - r);
    permanent += std::fabs(m[0][k]) * (std::fabs(l) + std::fabs(r));
    first_row += std::fabs(m[0][k]);
  }
  const double error = kDeterminantErrorMultiplier * permanent + kMinorUnderflowError * first_row +
                       kEdgeUnderflowError;
  const int sign = Certain(sum, error);
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
