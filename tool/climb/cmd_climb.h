// The verb climb.
#ifndef RASTERPROOF_TOOL_CLIMB_CMD_CLIMB_H_
#define RASTERPROOF_TOOL_CLIMB_CMD_CLIMB_H_

#include <cstdint>
#include <string>

namespace rasterproof::tool {

/// A search for the largest error over its bound.
struct ClimbOptions {
  std::string subject = "f32-direct";
  std::string property = "EdgeErrorStaysWithinItsBound";
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 20'000;
  std::string from;    ///< a case file to start from as well; empty: only drawn cases
  std::string output;  ///< file; empty: none
};
int RunClimb(const ClimbOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CLIMB_CMD_CLIMB_H_
