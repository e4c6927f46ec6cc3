// The clocks by which draws are timed.
#ifndef RASTERPROOF_CORE_CLOCK_H_
#define RASTERPROOF_CORE_CLOCK_H_

#include <ctime>

namespace rasterproof {

/// How long something took.
struct DrawTime {
  double seconds = 0;       ///< of processor time, all threads
  double wall_seconds = 0;  ///< elapsed
};

inline double SecondsOf(clockid_t clock) {
  std::timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of all threads of this process.
inline double ProcessSeconds() { return SecondsOf(CLOCK_PROCESS_CPUTIME_ID); }

/// Processor time of the calling thread.
inline double ThreadSeconds() { return SecondsOf(CLOCK_THREAD_CPUTIME_ID); }

/// Time since a fixed moment.
inline double WallSeconds() { return SecondsOf(CLOCK_MONOTONIC); }

/// Times one call in this process.
template <class Call>
DrawTime Timed(const Call& call) {
  const double wall = WallSeconds();
  const double start = ProcessSeconds();
  call();
  const double end = ProcessSeconds();
  return {.seconds = end - start, .wall_seconds = WallSeconds() - wall};
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CLOCK_H_
