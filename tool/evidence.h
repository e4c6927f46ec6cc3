// What was proved of a subject's arithmetic, and where its proof was run.
#ifndef RASTERPROOF_TOOL_EVIDENCE_H_
#define RASTERPROOF_TOOL_EVIDENCE_H_

#include <vector>

#include "core/subject_info.h"
#include "report/certificate.h"

namespace rasterproof::tool {

/// Each statement with its script, named by the SHA-256 that the script had when this program was
/// built, and what the tests recorded of its run: proofs/NAME.json beside the command
/// (scripts/prove). Without a record of that very script it says "not run for this source".
std::vector<report::Evidence> ProvedOf(const SubjectInfo& info);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_EVIDENCE_H_
