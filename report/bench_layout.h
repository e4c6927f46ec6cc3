// Where the parts of a plot lie: scales, ticks, points of equal error, room for labels.
#ifndef RASTERPROOF_REPORT_BENCH_LAYOUT_H_
#define RASTERPROOF_REPORT_BENCH_LAYOUT_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// A logarithmic axis, from `from` to `to` in user units. Empty until it takes a value.
struct Axis {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  double from = 0;
  double to = 0;

  void Take(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void Widen(double factor) {
    low /= factor;
    high *= factor;
  }
  double At(double value) const {
    const double part = std::log(std::clamp(value, low, high) / low) / std::log(high / low);
    return from + (to - from) * part;
  }
};

/// 1, 5 and 2 times powers of ten within the axis, as far as there is room of `least` between them.
std::vector<double> Ticks(const Axis& axis, double least);

struct Place {
  const BenchRow* row = nullptr;
  double x = 0;
  double y = 0;
};

/// From left to right, and of equal ones the first in the record.
inline std::pair<double, const BenchRow*> OrderOf(const Place& place) {
  return {place.x, place.row};
}

struct Box {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  bool Meets(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
  }
  bool IsWithin(const Box& other) const {
    return x >= other.x && x + width <= other.x + other.width && y >= other.y &&
           y + height <= other.y + other.height;
  }
};

/// Moves points of equal error up and down within a lane, so that they lie beside each other, not
/// upon each other. They come in the order of their x.
void Spread(const std::vector<Place*>& points, double top, double height);

/// Finds a label of the width a box that meets none of those taken, beside the point first, then
/// farther off in all directions, and takes it. Returns nullptr where there is no room.
const Box* FindRoom(const Place& place, double width, const Box& limits, std::vector<Box>& taken);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_LAYOUT_H_
