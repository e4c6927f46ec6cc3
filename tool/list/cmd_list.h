// The verb list.
#ifndef RASTERPROOF_TOOL_LIST_CMD_LIST_H_
#define RASTERPROOF_TOOL_LIST_CMD_LIST_H_

#include <string>

namespace rasterproof::tool {

struct ListOptions {
  /// "subjects", "properties", "domains", "worlds", "profiles", "mutants", "keys", "clauses", or
  /// "all" but the last two
  std::string what = "all";
  std::string prefix;   ///< of clauses' ids; empty: all
  bool json = false;    ///< of clauses
  std::string subject;  ///< list only properties that apply to it; empty: all
};
int RunList(const ListOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LIST_CMD_LIST_H_
