// The verb sweep.
#ifndef RASTERPROOF_TOOL_SWEEP_CMD_SWEEP_H_
#define RASTERPROOF_TOOL_SWEEP_CMD_SWEEP_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof::tool {

/// Builds of a rasterizer by several compilers and flags.
struct SweepOptions {
  std::vector<std::string> sources;
  std::string cflags;               ///< words of a shell, for every build
  std::vector<std::string> builds;  ///< builds to compare with the base; empty: the usual list
  std::string profile;
  std::uint64_t seed = 1;
  std::uint64_t cases = 200;
  double seconds = 30;  ///< of one compilation, or of one answer
  std::string json;     ///< file; empty: none
  int jobs = 1;         ///< builds at once
};
int RunSweep(const SweepOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SWEEP_CMD_SWEEP_H_
