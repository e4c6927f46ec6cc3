// The subject rounds:FOLDER: a program that is not at hand, asked in rounds of files.
#ifndef RASTERPROOF_TOOL_PIPE_CMD_ROUNDS_H_
#define RASTERPROOF_TOOL_PIPE_CMD_ROUNDS_H_

#include "tool/case/cmd_case.h"
#include "tool/infer/cmd_infer.h"

namespace rasterproof::tool {

/// `replay --shrink` and `infer` on a subject rounds:FOLDER. What the program states is in
/// FOLDER/program.subject, if that is there. Each call runs the verb on the answers of all earlier
/// rounds. Where one is missing, it writes the next round and returns kExitInconclusive.
int ShrinkInRounds(const ReplayOptions& options);
int InferInRounds(const InferOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PIPE_CMD_ROUNDS_H_
