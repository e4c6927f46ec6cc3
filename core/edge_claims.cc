#include "core/edge_claims.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ulp.h"

namespace rasterproof {
namespace {

// The size of the two products of E(a, b; p), rounded up: three roundings each, and one of the sum.
double Products(Point2 a, Point2 b, Point2 p) {
  const double first = std::fabs((p.x - a.x) * (b.y - a.y));
  const double second = std::fabs((p.y - a.y) * (b.x - a.x));
  return (first + second) * (1 + 0x1p-48) + std::numeric_limits<double>::denorm_min();
}

}  // namespace

// A product that underflows is off by up to the least subnormal, which no multiple of its size
// says. One that may overflow is no number to claim anything of.
double ClaimedEdges::Bound(double roundings, double products) const {
  if (roundings == 0) return 0;
  const bool is_float = precision_ == Precision::kFloat32;
  const double unit = is_float ? rounding_epsilon<float>() : rounding_epsilon<double>();
  const double least = is_float ? double{std::numeric_limits<float>::denorm_min()}
                                : std::numeric_limits<double>::denorm_min();
  const double largest =
      is_float ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
  if (!(products <= largest / 4)) return std::numeric_limits<double>::quiet_NaN();
  return roundings * (unit * products * (1 + 0x1p-48) + least);
}

double ClaimedEdges::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  if (!claims_.value_error) return std::numeric_limits<double>::quiet_NaN();
  return Bound(*claims_.value_error, Products(a, b, p));
}

std::vector<double> ClaimedEdges::WalkErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                  int steps) const {
  std::vector<double> bounds;
  const double length = static_cast<double>(step.sign) * step.length;
  for (int n = 0; n <= steps; ++n) {
    if (!claims_.walk_error) {
      bounds.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    // Along a line the products are largest at one of its ends.
    const Point2 end{step.along_y ? p.x : p.x + n * length, step.along_y ? p.y + n * length : p.y};
    bounds.push_back(
        Bound((n + 1) * *claims_.walk_error, std::max(Products(a, b, p), Products(a, b, end))));
  }
  return bounds;
}

}  // namespace rasterproof
