// Mistakes in what `legal` was given that its verdict lets one suspect.
#ifndef RASTERPROOF_TOOL_LEGAL_LEGAL_HINTS_H_
#define RASTERPROOF_TOOL_LEGAL_LEGAL_HINTS_H_

#include <string>
#include <vector>

#include "tool/legal/cmd_legal.h"
#include "tool/legal/legality.h"

namespace rasterproof::tool {

/// Returns a sentence for each mistake that the verdict on the drawing lets one suspect: clip space
/// that is not scaled to the viewport, ids that are counted from 0, a background of another colour.
///
/// Returns:    nothing of a drawing if its verdict is "legal". Ids are named only if they are
///             possible, counted from 0; a background only if it contradicts fewer samples.
std::vector<std::string> HintsOf(const LegalOptions& options, const JudgedScene& judged,
                                 const OneCall& drawn, const legal::JointVerdict& verdict);

/// What to do about a scene and a profile that the joint verdict refuses for this reason.
std::string RemedyOf(const std::string& why_not_joint);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_LEGAL_HINTS_H_
