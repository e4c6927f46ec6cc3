// Error against run time of values: every method on the same spans, held to exact rationals.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_BENCH_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_BENCH_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/values/value_kernels.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

struct ValueBenchOptions {
  std::vector<std::string> families;  ///< names; empty: all
  std::uint64_t seed = 1;
  std::uint64_t covered = 200'000;  ///< pixels of a family, about
  std::size_t judged = 2'000;       ///< of them
  int rounds = 15;
  std::function<void(const std::string&)> progress;  ///< may be empty
};

/// Of the instruction sets that this machine runs, widest first; none without AVX2.
std::vector<const ValueKernels*> SupportedValueKernels();

/// Fills value_families and value_rows: kernels by the widest vectors that this machine runs (none
/// without AVX2), and the library's values, fast and correctly rounded.
///
/// Each round draws every method on spans that were found before, from the first triangle's set-up
/// to the last store; its time is that less the floor's of the same round. A family in window space
/// has all methods, one in clip space those for any w. Of all families also value_limits.
///
/// Error:      InputError for a family that there is not.
void RunValues(const ValueBenchOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_BENCH_H_
