#include "model/drop.h"

#include <algorithm>
#include <cmath>

namespace rasterproof {
namespace {

// Whether high - low > most, though the difference rounds: rounding keeps the order; if the result
// is `most` itself, the rounding error (Knuth's TwoSum) decides by its sign.
bool DifferenceExceeds(double high, double low, double most) {
  const double difference = high - low;
  if (difference != most || !std::isfinite(difference)) return difference > most;
  const double from_low = difference - high;
  return (high - (difference - from_low)) - (low + from_low) > 0;
}

}  // namespace

bool Exceeds(const std::array<Point2, 3>& corners, const MaxPrimitiveExtent& extent) {
  const auto [left, right] = std::ranges::minmax(corners, {}, &Point2::x);
  const auto [low, high] = std::ranges::minmax(corners, {}, &Point2::y);
  return DifferenceExceeds(right.x, left.x, extent.width) ||
         DifferenceExceeds(high.y, low.y, extent.height);
}

}  // namespace rasterproof
