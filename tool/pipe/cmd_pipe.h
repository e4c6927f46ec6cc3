// The verbs pipe ask, judge, shrink and infer.
#ifndef RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
#define RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_

#include <cstdint>
#include <string>

#include "props/run/campaign_options.h"
#include "tool/case_choice.h"

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

/// A program that runs elsewhere and answers in rounds.
struct RoundsOptions {
  std::string folder;       ///< of the rounds' files
  std::string description;  ///< file; empty: the default description
  std::string profile;      ///< instead of the description's
};

struct ShrinkRoundsOptions {
  RoundsOptions rounds;
  CaseChoice choice;   ///< its subject and profile are ignored
  std::string output;  ///< file for the smallest case
  std::uint64_t evaluations = 10000;
};
int RunShrinkRounds(const ShrinkRoundsOptions& options);

struct InferRoundsOptions {
  RoundsOptions rounds;
  std::uint64_t seed = 1;
  std::string json;  ///< file; empty: none
};
int RunInferRounds(const InferRoundsOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PIPE_CMD_PIPE_H_
