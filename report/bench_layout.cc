#include "report/bench_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rasterproof::report {

// The largest powers first.
std::vector<double> Ticks(const Axis& axis, double least) {
  std::vector<double> ticks;
  for (const int digit : {1, 5, 2}) {
    for (int k = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
         k >= std::floor(std::log10(axis.low)); --k) {
      const double value = digit * std::pow(10, k);
      if (value < axis.low * (1 - 1e-9) || value > axis.high * (1 + 1e-9)) continue;
      const bool has_room = std::ranges::none_of(
          ticks, [&](double other) { return std::abs(axis.At(other) - axis.At(value)) < least; });
      if (has_room) ticks.push_back(value);
    }
  }
  return ticks;
}

void Spread(const std::vector<Place*>& points, double top, double height) {
  constexpr double kApart = 13;
  std::vector<double> ends;
  std::vector<std::size_t> levels;
  for (const Place* point : points) {
    const auto free =
        std::ranges::find_if(ends, [&](double end) { return point->x - end >= kApart; });
    levels.push_back(static_cast<std::size_t>(free - ends.begin()));
    if (free == ends.end()) {
      ends.push_back(point->x);
    } else {
      *free = point->x;
    }
  }
  const double gaps = std::max(1.0, static_cast<double>(ends.size()) - 1);
  const double step = std::min(kApart, (height - 14) / gaps);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double level =
        static_cast<double>(levels[k]) - (static_cast<double>(ends.size()) - 1) / 2;
    points[k]->y = top + height / 2 + level * step;
  }
}

const Box* FindRoom(const Place& place, double width, const Box& limits, std::vector<Box>& taken) {
  constexpr std::array<std::array<int, 2>, 8> kWays{
      {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
  constexpr double kHeight = 15;
  for (int off = 0; off < 14; ++off) {
    for (const auto& [across, down] : kWays) {
      const Box box{place.x - width / 2 + across * (width / 2 + 8 + 10 * off),
                    place.y - kHeight / 2 + down * (kHeight / 2 + 7 + 9 * off), width, kHeight};
      const bool is_free =
          std::ranges::none_of(taken, [&](const Box& other) { return other.Meets(box); });
      if (is_free && box.IsWithin(limits)) return &taken.emplace_back(box);
    }
  }
  return nullptr;
}

}  // namespace rasterproof::report
