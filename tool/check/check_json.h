// What check found, as data: docs/programs.md says what the keys mean.
#ifndef RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_
#define RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_

#include <span>
#include <string>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/property.h"
#include "tool/check/findings.h"

namespace rasterproof::tool {

/// Returns one object with the status of the run and, of each subject, its properties, failures and
/// causes. Keys are only ever added.
std::string CheckJson(std::span<const Findings> found, int status);

/// Returns a case and its outcome as a line, for --cases-json.
std::string CaseLine(const SubjectInfo& subject, const props::Property& property, const Case& c,
                     const Verdict& verdict);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CHECK_JSON_H_
