#include "report/proportion.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"

namespace rasterproof::report {

Interval ProportionInterval(std::uint64_t count, std::uint64_t of) {
  constexpr double kZ = 1.959964;
  const auto n = static_cast<double>(of);
  const double p = static_cast<double>(count) / n;
  const double centre = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double half = kZ * std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n)) / (1 + kZ * kZ / n);
  return {count == 0 ? 0 : std::max(0.0, centre - half),
          count == of ? 1 : std::min(1.0, centre + half)};
}

std::string Percent(double share) {
  return fmt::format("{:.{}g}", 100 * share, share < 0.995 ? 2 : 3);
}

std::string CountedText(std::uint64_t count, std::uint64_t of) {
  const Interval rate = ProportionInterval(count, of);
  return fmt::format("{} of {}, {} to {} %", count, of, Percent(rate.low), Percent(rate.high));
}

}  // namespace rasterproof::report
