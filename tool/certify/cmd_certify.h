// The verb certify.
#ifndef RASTERPROOF_TOOL_CERTIFY_CMD_CERTIFY_H_
#define RASTERPROOF_TOOL_CERTIFY_CMD_CERTIFY_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/authority.h"
#include "props/run/campaign_options.h"

namespace rasterproof::tool {

/// Cases `first` to `end` - 1 of a campaign.
struct CaseRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  friend bool operator==(const CaseRange&, const CaseRange&) = default;
};

struct CertifyOptions {
  std::vector<std::string> subjects;
  std::string profile;  ///< judge by this one; empty: by each subject's own
  bool all = false;
  std::string scene_set;  ///< file; empty: scenes/certify.json beside the command
  std::string output = "out";
  std::string bench;       ///< bench --json file for the page; empty: none
  std::string survey;      ///< folder of survey --json files for the page; empty: none
  std::string browser;     ///< address of the browser's page; empty: a copy beside the report
  bool catalogue = false;  ///< the matrix of stiff and extreme cases on the page
  props::CampaignOptions campaign;
  /// Only these cases, as a part; `campaign.cases` is ignored.
  std::optional<CaseRange> range;
  std::string shard;                ///< only this shard, as a part: "2/5" or "auto"; empty: all
  std::vector<std::string> worlds;  ///< small worlds to run exhaustively
  int jobs = 1;                     ///< properties or scenes at once
  FailOn fail_on = FailOn::kStated;
  /// Files of parts of one subject's campaign to merge (RunMerge): no case is run.
  std::vector<std::string> parts;
  /// A page's certificate to judge again (RunPassport): nothing else is run.
  std::string passport;
};
int RunCertify(const CertifyOptions& options);
/// The subject is the one that the parts name unless the options name one.
int RunMerge(const CertifyOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_CMD_CERTIFY_H_
