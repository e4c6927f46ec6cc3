#include "tool/exit_status.h"

#include <algorithm>
#include <array>

namespace rasterproof::tool {

int StatusOf(Outcome outcome) {
  if (outcome == Outcome::kViolated) return kExitViolated;
  return outcome == Outcome::kHolds ? kExitHolds : kExitInconclusive;
}

int WorseStatus(int a, int b) {
  constexpr std::array<int, 5> kWorstFirst{kExitFault, kExitUsage, kExitViolated, kExitInconclusive,
                                           kExitHolds};
  return *std::ranges::find_if(kWorstFirst, [&](int status) { return status == a || status == b; });
}

}  // namespace rasterproof::tool
