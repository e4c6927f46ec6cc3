// What `compare --mode` compares with: the subject itself in other floating-point modes.
#ifndef RASTERPROOF_TOOL_COMPARE_FLOAT_MODES_H_
#define RASTERPROOF_TOOL_COMPARE_FLOAT_MODES_H_

#include <string>
#include <vector>

#include "core/comparison.h"
#include "core/float_mode.h"
#include "props/compare/compare.h"
#include "tool/compare/comparison.h"
#include "tool/progress.h"
#include "tool/resolve.h"

namespace rasterproof::tool {

/// Error:      InputError for a name that is none, or a mode that the processor lacks.
std::vector<FloatMode> ModesNamed(const std::vector<std::string>& names);

/// The ways in which a mode reaches a subject: set at the call, before its library is loaded, or in
/// threads of its host. A replay sets it at the call; a mode fails what states exact coverage.
std::vector<Column> WaysOfModes(bool states_exact);

/// The cells of each mode, by way, of the first cases of EnvironmentKeepsCoverage.
///
/// Error:      InputError for a program on a pipe, whose mode is its own.
std::vector<std::vector<Cell>> CompareModes(const SubjectFactory& subject,
                                            const std::vector<FloatMode>& modes,
                                            const ComparisonTable& table,
                                            const props::Limits& limits, Progress& progress);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMPARE_FLOAT_MODES_H_
