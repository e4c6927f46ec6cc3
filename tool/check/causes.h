// What explains violations, as lines.
#ifndef RASTERPROOF_TOOL_CHECK_CAUSES_H_
#define RASTERPROOF_TOOL_CHECK_CAUSES_H_

#include <string>

#include "tool/check/findings.h"

namespace rasterproof::tool {

/// A line for each cause, with the properties that it explains, and a line with their numbers.
/// Empty without causes.
std::string CausesText(const Findings& found);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CAUSES_H_
