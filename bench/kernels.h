// `bench --kernels`: every kernel on the same scenes in one run, interleaved.
#ifndef RASTERPROOF_BENCH_KERNELS_H_
#define RASTERPROOF_BENCH_KERNELS_H_

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/kernel_scenes.h"
#include "core/coverage.h"
#include "core/kernel_bench_result.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "reference/kernels/kernel.h"

namespace rasterproof::bench {

/// Another rasterizer, drawn beside the kernels of the sink facing.
struct Rival {
  std::string name;
  CoverageKind coverage = CoverageKind::kFacingCounts;
  std::function<void(const Scene&, CoverageCounts&)> draw;
};

/// "rows": what spans-exact draws float64 by, one row and triangle at a time.
Rival RowsRival();

struct KernelBenchOptions {
  std::vector<reference::kernels::Target> targets;
  std::vector<reference::kernels::Sink> sinks;
  std::vector<reference::kernels::KernelMethod> methods;
  std::vector<Rival> rivals;
  int repetitions = 7;
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// Adds what is measured on one scene to the result: a row for each method, sink and target,
/// and one for each rival, whose time is what the scene takes longer than an empty one.
///
/// Wrong:      against spans-exact by rows. count8, facing: the sum of the counts' differences;
///             mask: bits; id: pixels of another triangle than the last one that covers them;
///             depth: pixels with a depth that nothing covers, or without one.
void BenchKernelScene(const KernelInput& input, const KernelBenchOptions& options,
                      KernelBenchResult& result);

/// Adds the limits of each sink and target for surfaces of the result's size.
void BenchKernelLimits(const KernelBenchOptions& options, KernelBenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_KERNELS_H_
