#include "bench/paired.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::bench {

std::vector<std::size_t> RoundOrder(std::size_t count, std::size_t round) {
  // The first row of the square is 0, 1, n-1, 2, n-2, ...: neighbours differ by every step once.
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t step = i % 2 == 1 ? (i + 1) / 2 : count - i / 2;
    order[i] = (step + round / 2) % count;
  }
  // The mirrored rows balance the followers where the count is odd.
  if (round % 2 == 1) std::ranges::reverse(order);
  return order;
}

Interval RatioInterval(std::span<const double> seconds, std::span<const double> baseline) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(seconds.size(), baseline.size()); ++i) {
    ratios.push_back(baseline[i] > 0 ? seconds[i] / baseline[i] : 0);
  }
  return ratios.empty() ? Interval{} : MedianInterval(std::move(ratios));
}

}  // namespace rasterproof::bench
