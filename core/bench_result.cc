#include "core/bench_result.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rasterproof {
namespace {

// How many values are cut off at either end: the largest k with P(fewer than k of n coins show
// heads) <= 2.5 %.
std::size_t CutOff(std::size_t n) {
  double probability = std::ldexp(1.0, -static_cast<int>(n));  // of exactly k heads
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

Interval MedianInterval(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const std::size_t cut = CutOff(n);
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  return {.low = values[cut], .median = median, .high = values[n - 1 - cut]};
}

}  // namespace rasterproof
