// The clock of the benchmarks.
#ifndef RASTERPROOF_BENCH_THREAD_SECONDS_H_
#define RASTERPROOF_BENCH_THREAD_SECONDS_H_

#include <ctime>

namespace rasterproof::bench {

/// Processor time of the calling thread.
inline double ThreadSeconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_THREAD_SECONDS_H_
