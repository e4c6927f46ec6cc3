#include "core/stated_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ulp.h"

namespace rasterproof {
namespace {

using Sizes = StatedEdges::Sizes;

Sizes SizesOf(Point2 a, Point2 b, Point2 p) {
  const double first = std::fabs((p.x - a.x) * (b.y - a.y));
  const double second = std::fabs((p.y - a.y) * (b.x - a.x));
  // Rounded up: three roundings each, and one of the sum.
  const double products =
      (first + second) * (1 + 0x1p-48) + std::numeric_limits<double>::denorm_min();
  return {std::max({std::fabs(p.x - a.x), std::fabs(p.y - a.y), std::fabs(b.x - a.x),
                    std::fabs(b.y - a.y)}),
          products};
}

Sizes Larger(const Sizes& one, const Sizes& other) {
  return {std::max(one.factors, other.factors), std::max(one.products, other.products)};
}

}  // namespace

// A product that underflows is off by up to the least subnormal, which no multiple of its size
// says. Where a difference or a product may overflow there is no number to state anything of.
double StatedEdges::Bound(double roundings, const Sizes& sizes) const {
  if (roundings == 0) return 0;
  const bool is_float = precision_ == Precision::kFloat32;
  const double unit = is_float ? rounding_epsilon<float>() : rounding_epsilon<double>();
  const double least = is_float ? double{std::numeric_limits<float>::denorm_min()}
                                : std::numeric_limits<double>::denorm_min();
  const double largest =
      is_float ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
  const bool may_overflow = !(sizes.products <= largest / 4) || !(sizes.factors <= largest / 4);
  if (may_overflow) return std::numeric_limits<double>::quiet_NaN();
  return roundings * (unit * sizes.products * (1 + 0x1p-48) + least);
}

double StatedEdges::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  if (!stated_.value_error) return std::numeric_limits<double>::quiet_NaN();
  return Bound(*stated_.value_error, SizesOf(a, b, p));
}

std::vector<double> StatedEdges::SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                     int steps) const {
  std::vector<double> bounds;
  const double length = static_cast<double>(step.sign) * step.length;
  for (int n = 0; n <= steps; ++n) {
    if (!stated_.stepping_error) {
      bounds.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    // Along a line the sizes are largest at one of its ends.
    const Point2 end{step.along_y ? p.x : p.x + n * length, step.along_y ? p.y + n * length : p.y};
    bounds.push_back(
        Bound((n + 1) * *stated_.stepping_error, Larger(SizesOf(a, b, p), SizesOf(a, b, end))));
  }
  return bounds;
}

}  // namespace rasterproof
