// How a failure is shown: one line with hex vertices, a small picture, and the command that replays
// it.
#ifndef RASTERPROOF_TOOL_FAILURE_H_
#define RASTERPROOF_TOOL_FAILURE_H_

#include <string>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "report/picture.h"

namespace rasterproof::tool {

/// Expected and observed coverage of the case around the witness, with the exact edge values there.
///
/// Domain:     a case that the subject takes.
report::Explanation Explain(Subject& subject, const Case& c, const Verdict& verdict,
                            const std::string& replay);

/// "property: triangle 0 (0x1p+0, 0x0p+0) ... => observed 2, expected 1".
std::string FailureLine(const std::string& property, const Case& c, const Verdict& verdict);

/// The line, the picture and the replay command.
std::string FailureText(Subject& subject, const std::string& property, const Case& c,
                        const Verdict& verdict, const std::string& replay, bool colour);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_FAILURE_H_
