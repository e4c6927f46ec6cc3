// `bench --kernels`: every kernel on the same scenes in one run, interleaved.
#ifndef RASTERPROOF_BENCH_KERNELS_H_
#define RASTERPROOF_BENCH_KERNELS_H_

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/kernel_scenes.h"
#include "core/kernel_bench_result.h"
#include "reference/kernels/kernel.h"

namespace rasterproof::bench {

struct KernelBenchOptions {
  std::vector<reference::kernels::Target> targets;
  std::vector<reference::kernels::Sink> sinks;
  std::vector<reference::kernels::KernelMethod> methods;
  int repetitions = 7;
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// Adds what is measured on one scene to the result: a row for each method, sink and target.
///
/// Wrong:      against spans-exact. count8, facing: the sum of the counts' differences; mask: bits;
///             id: pixels of another triangle than the last one that covers them; depth: pixels
///             with a depth that nothing covers, or without one.
void BenchKernelScene(const KernelInput& input, const KernelBenchOptions& options,
                      KernelBenchResult& result);

/// Adds the limits of each sink and target for surfaces of the result's size.
void BenchKernelLimits(const KernelBenchOptions& options, KernelBenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_KERNELS_H_
