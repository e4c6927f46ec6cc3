// Running one case again, and shrinking it, on a subject that is made already.
#ifndef RASTERPROOF_TOOL_CASE_REPLAY_H_
#define RASTERPROOF_TOOL_CASE_REPLAY_H_

#include <cstdint>

#include "core/subject.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tool/case/cmd_case.h"
#include "tool/load_case.h"

namespace rasterproof::tool {

/// What the case is judged by: its property, or that the counts are the model's.
const props::Property& PropertyOf(const LoadedCase& loaded);

/// How a case is shrunk that was named on the command line: by as many evaluations, in any time.
props::CampaignOptions ShrinkingBy(const Subject& subject, std::uint64_t evaluations);

/// What `replay` does with the case: judges or shrinks it, writes it, prints what was found.
/// Returns the exit status.
int Replay(const ReplayOptions& options, LoadedCase loaded);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CASE_REPLAY_H_
