// The verbs pipe ask and judge.
#ifndef RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
#define RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_

#include <string>

#include "props/run/campaign_options.h"

namespace rasterproof::tool {

/// What goes through a pipe by hand: pipe ask | PROGRAM | pipe judge.
struct PipeOptions {
  std::string property = "CoverageEqualsTheModel";
  std::string description;  ///< file; empty: what is assumed of a program that says nothing
  std::string profile;      ///< in place of the description's
  props::CampaignOptions campaign;
};
int RunAsk(const PipeOptions& options);
int RunJudge(const PipeOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
