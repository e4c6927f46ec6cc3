// The verb compare.
#ifndef RASTERPROOF_TOOL_COMPARE_CMD_COMPARE_H_
#define RASTERPROOF_TOOL_COMPARE_CMD_COMPARE_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/authority.h"
#include "props/run/campaign_options.h"

namespace rasterproof::tool {

/// Cases by yardsticks.
struct CompareOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> scenes;             ///< rows: scene files; empty: families
  std::vector<std::string> families;           ///< rows: these; empty: all, if no scene is named
  std::vector<std::string> by{"own", "real"};  ///< columns: these, or names of other subjects
  std::vector<std::string> modes;              ///< rows: floating-point modes of the subject itself
  std::string profile;                         ///< judge by this one instead of the subject's own
  bool device = false;                         ///< narrowed by the subject's own numbers
  props::CampaignOptions campaign;
  std::size_t list_length = 0;  ///< 0: the subject's own
  FailOn fail_on = FailOn::kStated;
  std::string save;  ///< folder for the worst case of each cell that fails
  std::string json;  ///< file; empty: none
  int jobs = 1;      ///< rows at once
};
int RunCompare(const CompareOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMPARE_CMD_COMPARE_H_
