// What a benchmark of kernels found: measured by bench, rendered by report.
#ifndef RASTERPROOF_CORE_KERNEL_BENCH_RESULT_H_
#define RASTERPROOF_CORE_KERNEL_BENCH_RESULT_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof {

/// Seconds of the thread's CPU time, of repetitions interleaved with all others of the run.
struct Times {
  double median = 0;
  double least = 0;
  double spread = 0;  ///< between the first and the third quartile
};

/// One method on one scene, into one sink, by one SIMD target.
struct KernelBenchRow {
  std::string scene;
  std::string sink;
  std::string method;
  std::string target;
  Times times;              ///< of one draw of the scene
  std::uint64_t wrong = 0;  ///< samples that differ from the exact ones: see bench/kernels.h
};

struct KernelBenchScene {
  std::string name;
  std::string summary;
  std::uint64_t triangles = 0;
  std::uint64_t covered = 0;  ///< samples covered, each as often as it is
};

/// One pass over the target: the limit of what is stored.
struct KernelBenchLimit {
  std::string sink;
  std::string target;
  Times times;
};

struct KernelBenchResult {
  int width = 0;
  int height = 0;
  int repetitions = 0;
  std::uint64_t seed = 0;
  std::vector<KernelBenchScene> scenes;
  std::vector<KernelBenchRow> rows;
  std::vector<KernelBenchLimit> limits;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_KERNEL_BENCH_RESULT_H_
