// Proofs of a subject's arithmetic and where they ran; what the subject was not asked.
#ifndef RASTERPROOF_TOOL_CERTIFY_EVIDENCE_H_
#define RASTERPROOF_TOOL_CERTIFY_EVIDENCE_H_

#include <span>
#include <vector>

#include "core/result.h"
#include "core/subject_info.h"
#include "props/judging/gate.h"
#include "report/certificate.h"

namespace rasterproof::tool {

/// Each statement with its script, named by the SHA-256 that the script had when this program was
/// built, and the tests' record of its run: proofs/NAME.json beside the command
/// (scripts/prove). Without a record of that very script it says "not run for this source".
std::vector<report::Evidence> ProvedOf(const SubjectInfo& info);

/// As props::NotAsked(): each with its reason, which may be empty.
std::vector<report::Evidence> UnaskedOf(const SubjectInfo& info,
                                        std::span<const props::Shows> outputs,
                                        std::span<const PropertyResult> results);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_EVIDENCE_H_
