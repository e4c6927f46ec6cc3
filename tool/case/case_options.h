// Options of the verbs that take one case. Beside tool/verb_options.h.
#ifndef RASTERPROOF_TOOL_CASE_CASE_OPTIONS_H_
#define RASTERPROOF_TOOL_CASE_CASE_OPTIONS_H_

#include <string>

#include "CLI/CLI.hpp"
#include "tool/case_choice.h"

namespace rasterproof::tool {

/// Adds a case, and what it is judged with and by.
void AddCase(CLI::App* app, CaseChoice& choice);

/// Adds --as.
CLI::Option* AddAs(CLI::App* app, std::string& as);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CASE_CASE_OPTIONS_H_
