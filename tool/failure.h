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

/// "property: triangle 0 (0x1p+0, 0x0p+0) ... => observed 2, expected 1; why". What the verdict
/// does not tell is left out.
std::string FailureLine(const std::string& property, const Case& c, const Verdict& verdict);

/// The case's scene in one line, which a scene file may hold as it is: hex coordinates, triangles;
/// and how it was drawn, where that is not the plain way. Says only how large it is where that is
/// more than anybody reads.
std::string SceneLine(const Case& c);

/// The line, the scene, the picture if there is a place to show, and the replay command.
std::string FailureText(Subject& subject, const std::string& property, const Case& c,
                        const Verdict& verdict, const std::string& replay, bool colour);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_FAILURE_H_
