// What a command's exit status says of verdicts.
#ifndef RASTERPROOF_TOOL_EXIT_STATUS_H_
#define RASTERPROOF_TOOL_EXIT_STATUS_H_

#include "core/verdict.h"

namespace rasterproof::tool {

/// Exit statuses.
inline constexpr int kExitHolds = 0;
inline constexpr int kExitViolated = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitFault = 3;
inline constexpr int kExitInconclusive = 4;

/// The status of one verdict: kExitHolds, kExitViolated, and kExitInconclusive for all that is
/// neither.
int StatusOf(Outcome outcome);

/// The worse of two statuses. From the worst: a fault of ours, what the caller must mend, violated,
/// inconclusive, holds. A subject that exercised nothing beside one that holds is inconclusive.
int WorseStatus(int a, int b);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_EXIT_STATUS_H_
