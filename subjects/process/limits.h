// What a program that draws may cost.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_LIMITS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_LIMITS_H_

#include <cstdint>

namespace rasterproof::subjects {

struct ProcessLimits {
  double seconds = 10;                           ///< of the program's time, for one answer
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of address space; 0: no limit
  int long_waits = 3;  ///< in vain or for a late answer, each of ten times the seconds
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_LIMITS_H_
