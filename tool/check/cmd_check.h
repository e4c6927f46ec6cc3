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
  std::vector<std::string> named;   ///< drawn cases by name; without these and scenes: a campaign
  std::string profile;              ///< judge by this one instead of the subject's own
  bool device = false;              ///< narrowed by the subject's own numbers
  props::CampaignOptions campaign;
  std::string save;             ///< folder for counterexamples; saved ones are replayed first
  std::string cases_json;       ///< file with a JSON line per drawn case; empty: none
  int jobs = 1;                 ///< properties at once
  std::size_t list_length = 0;  ///< 0: the subject's own
  FailOn fail_on = FailOn::kStated;
  bool no_cause = false;  ///< do not explain violations
  /// Time limit for explaining violations.
  double cause_seconds = props::kCauseSeconds;
  std::string known;       ///< file of known failures, which do not fail the run; empty: none
  std::string json;        ///< file; empty: none
  bool verbose = false;    ///< every line, and every failure in full
  bool fail_fast = false;  ///< ends with the first violation
};
int RunCheck(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CMD_CHECK_H_
