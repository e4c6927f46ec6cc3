// The verbs about one case: replay, explain, convert.
#ifndef RASTERPROOF_TOOL_CASE_CMD_CASE_H_
#define RASTERPROOF_TOOL_CASE_CMD_CASE_H_

#include <cstdint>
#include <string>

#include "tool/case_choice.h"

namespace rasterproof::tool {

struct ReplayOptions {
  CaseChoice choice;
  std::string shrink;  ///< file for the smallest case that still fails; empty: as it is
  std::uint64_t evaluations = 10000;
  std::string as{};  ///< print the case in this one of report::kCodeLanguages; empty: do not
};
int RunReplay(const ReplayOptions& options);

struct ExplainOptions {
  CaseChoice choice;
  int x = -1;
  int y = -1;
  std::string svg;
  std::string png;
  bool colour = false;
  std::string as;  ///< as of ReplayOptions
};
int RunExplain(const ExplainOptions& options);

/// A case as a file of another kind.
struct ConvertOptions {
  CaseChoice choice;
  std::string to;  ///< "case" or "fuzz-input"
  std::string output = "-";
};
int RunConvert(const ConvertOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CASE_CMD_CASE_H_
