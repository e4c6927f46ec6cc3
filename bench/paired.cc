#include "bench/paired.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::bench {
namespace {

// How many values are cut off at either end: the largest k with P(fewer than k of n coins show
// heads) <= 2.5 %.
std::size_t CutOff(std::size_t n) {
  double probability = std::pow(0.5, static_cast<double>(n));  // of exactly k heads
  double below = 0;
  std::size_t k = 0;
  while (below + probability <= 0.025) {
    below += probability;
    probability *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    ++k;
  }
  return k == 0 ? 0 : k - 1;
}

}  // namespace

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

Interval MedianInterval(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const std::size_t cut = CutOff(n);
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  return {.low = values[cut], .median = median, .high = values[n - 1 - cut]};
}

Interval RatioInterval(std::span<const double> seconds, std::span<const double> baseline) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(seconds.size(), baseline.size()); ++i) {
    ratios.push_back(baseline[i] > 0 ? seconds[i] / baseline[i] : 0);
  }
  return ratios.empty() ? Interval{} : MedianInterval(std::move(ratios));
}

}  // namespace rasterproof::bench
