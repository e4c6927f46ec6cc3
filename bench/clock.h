// The clocks of the benchmarks.
#ifndef RASTERPROOF_BENCH_CLOCK_H_
#define RASTERPROOF_BENCH_CLOCK_H_

#include <ctime>

namespace rasterproof::bench {

inline double SecondsOf(clockid_t clock) {
  std::timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of all threads of this process.
inline double ProcessSeconds() { return SecondsOf(CLOCK_PROCESS_CPUTIME_ID); }

/// Time since a fixed moment.
inline double WallSeconds() { return SecondsOf(CLOCK_MONOTONIC); }

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CLOCK_H_
