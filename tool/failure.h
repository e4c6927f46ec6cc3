// How a failure is shown: one line with hex vertices, a small picture, and the command that replays
// it.
#ifndef RASTERPROOF_TOOL_FAILURE_H_
#define RASTERPROOF_TOOL_FAILURE_H_

#include <string>

#include "core/case.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "io/check_json.h"
#include "props/run/failure_view.h"
#include "report/picture.h"

namespace rasterproof::tool {

using io::InOneLine;
using io::WithCountsAsGiven;
using props::AsDrawn;

/// Whether the verdict holds what the subject drew of the failing scene.
bool HoldsWhatWasSeen(const Verdict& verdict, const Case& c);
/// Adds to the verdict what the subject draws of the failing scene, if the verdict does not hold it
/// yet: a blank target if it breaks down over it now.
///
/// Domain:     a case that the subject takes.
/// Error:      SubjectStop if there is no drawing; InputError if the target is too large.
void See(Subject& subject, const Case& c, Verdict& verdict);
/// See(), for a verdict that has a place to show. Without a drawing there will be no picture.
void SeeIfItCan(Subject& subject, const Case& c, Verdict& verdict);

/// Expected and observed coverage of what was drawn, around the witness, with the exact edge values
/// there.
///
/// Domain:     a verdict that holds what was seen; no more than a blank target is shown of others.
/// Error:      InputError if the oracle does not decide the scene.
report::Explanation Explain(const SubjectInfo& subject, const Case& c, const Verdict& verdict,
                            const std::string& replay);

/// "property: triangle 0 (0x1p+0, 0x0p+0) ... => observed 2, expected 1; why". What the verdict
/// does not tell is left out.
std::string FailureLine(const SubjectInfo& subject, const std::string& property, const Case& c,
                        const Verdict& verdict);

/// The case's scene in one line, which a scene file may hold as it is: hex coordinates, triangles;
/// and how it was drawn, where that is not the plain way. Says only how large it is where that is
/// more than anybody reads.
std::string SceneLine(const Case& c);

/// Returns the same for the case that the property drew instead, as a separate line; empty if it
/// drew the case itself.
std::string DrawnLine(const Case& c, const Verdict& verdict);

/// The line, the scene, what was drawn, the picture if the verdict holds one, and the replay
/// command.
std::string FailureText(const SubjectInfo& subject, const std::string& property, const Case& c,
                        const Verdict& verdict, const std::string& replay);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_FAILURE_H_
