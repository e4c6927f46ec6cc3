// What check found, as data: docs/programs.md says what the keys mean.
#ifndef RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_
#define RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_

#include <span>
#include <string>

#include "tool/check/findings.h"

namespace rasterproof::tool {

/// Returns one object with the status of the run and, of each subject, its properties, failures and
/// causes. Keys are only ever added.
std::string CheckJson(std::span<const Findings> found, int status);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_
