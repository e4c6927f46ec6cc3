// What explains violations, as lines.
#ifndef RASTERPROOF_TOOL_CHECK_CAUSES_H_
#define RASTERPROOF_TOOL_CHECK_CAUSES_H_

#include <string>

#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "tool/check/findings.h"

namespace rasterproof::tool {

/// The cause's section of docs/causes.md: "truncation", or "none".
std::string NameOfCause(const props::Cause& cause);

/// What was found, without its section: "your answers equal those of ...".
std::string CauseText(const props::Cause& cause, const props::Causes& causes);

/// A line for each cause, with the properties that it explains, and a line with their numbers.
/// Empty without causes.
std::string CausesText(const Findings& found);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CAUSES_H_
