// The verbs pipe ask and judge.
#ifndef RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
#define RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_

#include <string>

#include "props/run/campaign_options.h"

namespace rasterproof::tool {

/// Options of a user's own pipe: pipe ask | PROGRAM | pipe judge.
struct PipeOptions {
  std::string property = "CoverageEqualsTheModel";
  std::string description;  ///< file; empty: the default description
  std::string profile;      ///< instead of the description's
  props::CampaignOptions campaign;
};
int RunAsk(const PipeOptions& options);
int RunJudge(const PipeOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
