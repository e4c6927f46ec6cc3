// The command rasterproof, as a function: its verbs, options and exit statuses.
#ifndef RASTERPROOF_TOOL_COMMAND_LINE_H_
#define RASTERPROOF_TOOL_COMMAND_LINE_H_

#include <string>

namespace rasterproof::tool {

/// Runs what the arguments say. `own` is the subject where none is named.
///
/// Returns:    the exit status; never throws.
int RunCommandLine(int argc, char** argv, const std::string& own);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMMAND_LINE_H_
