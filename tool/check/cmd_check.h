// The verb check.
#ifndef RASTERPROOF_TOOL_CHECK_CMD_CHECK_H_
#define RASTERPROOF_TOOL_CHECK_CMD_CHECK_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/authority.h"
#include "props/cause/cause.h"
#include "props/run/campaign_options.h"

namespace rasterproof::tool {

struct CheckOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> properties;
  std::vector<std::string> scenes;  ///< case or scene files
  std::vector<std::string> named;   ///< drawn cases, by their names; no scenes either: a campaign
  std::string profile;              ///< judge by this one instead of the subject's own
  bool device = false;              ///< with the numbers of its device in it
  props::CampaignOptions campaign;
  std::string save;             ///< folder for counterexamples; those there are asked first
  std::string cases_json;       ///< file for a line of JSON a drawn case; empty: none
  int jobs = 1;                 ///< properties at once
  std::size_t list_length = 0;  ///< 0: the subject's own
  FailOn fail_on = FailOn::kStated;
  bool no_cause = false;  ///< violations are not explained
  /// At most, for what explains them.
  double cause_seconds = props::kCauseSeconds;
  std::string known;       ///< file of failures that fail nothing; empty: none
  std::string json;        ///< file; empty: none
  bool verbose = false;    ///< every line, and every failure in full
  bool fail_fast = false;  ///< ends with the first violation
};
int RunCheck(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CMD_CHECK_H_
