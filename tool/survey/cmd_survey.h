// The verb survey.
#ifndef RASTERPROOF_TOOL_SURVEY_CMD_SURVEY_H_
#define RASTERPROOF_TOOL_SURVEY_CMD_SURVEY_H_

#include <string>

#include "props/run/campaign_options.h"

namespace rasterproof::tool {

struct SurveyOptions {
  std::string subject = "spans-exact";
  std::string profile;  ///< used instead of the subject's own
  props::CampaignOptions campaign{.cases = 2000};
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the worst case of each cell that fails
  int jobs = 1;      ///< domains at once
};
int RunSurvey(const SurveyOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SURVEY_CMD_SURVEY_H_
