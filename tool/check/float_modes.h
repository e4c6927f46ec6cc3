// What `check --fp-env` does.
#ifndef RASTERPROOF_TOOL_CHECK_FLOAT_MODES_H_
#define RASTERPROOF_TOOL_CHECK_FLOAT_MODES_H_

#include "tool/commands.h"

namespace rasterproof::tool {

/// Prints for each subject how often its coverage depends on each mode, set in each of the ways
/// that reach it, and saves the first case of each mode that changes it when set at the call: a
/// replay sets it there.
///
/// Returns:    the exit status: violated if a subject that states exact coverage draws another one
///             in some mode, or any with --fail-on quality; inconclusive if no case could be
///             touched.
/// Error:      InputError for a program on a pipe, whose mode is its own.
int CheckFloatModes(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_FLOAT_MODES_H_
