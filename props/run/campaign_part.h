// Part of a campaign: what cases in a row came to, so that parts can be put together.
#ifndef RASTERPROOF_PROPS_RUN_CAMPAIGN_PART_H_
#define RASTERPROOF_PROPS_RUN_CAMPAIGN_PART_H_

#include <cstdint>
#include <optional>
#include <string>

#include "core/result.h"
#include "core/subject.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "props/run/tally.h"

namespace rasterproof::props {

/// How the run of a part ended.
enum class End : std::uint8_t {
  kAllRun,         ///< with its last case
  kNotApplicable,  ///< before its first case
  kFailed,         ///< with a case that failed
  kInconclusive,   ///< with a case that could not be judged
  kTimeUp,         ///< sooner: its time was up
  kInterrupted     ///< sooner: it was stopped
};

struct CampaignPart {
  Sums sums;  ///< up to the case that it ended with, that one included
  End end = End::kAllRun;
  std::string why;                      ///< of kNotApplicable and kInconclusive
  std::optional<Counterexample> found;  ///< of kFailed
  std::string failing_case;             ///< its name before it was shrunk
  double seconds = 0;
};

/// Whether no case after the part counts.
inline bool EndsTheCampaign(const CampaignPart& part) { return part.end != End::kAllRun; }

/// Runs the cases of the options, as RunCampaign does.
///
/// Error:      JudgingFault.
CampaignPart RunPart(Subject& subject, const Property& property, const CampaignOptions& options);

/// Adds the part that follows. The sum is what RunPart gives over the cases of both, if what the
/// subject draws depends on nothing but the scene, and no limit of time was met. A part after one
/// that ends the campaign adds its seconds alone.
void Add(CampaignPart& part, const CampaignPart& next);

/// The result of a campaign: that of RunCampaign over the part's cases.
PropertyResult ResultOf(const Subject& subject, const Property& property, std::uint64_t seed,
                        const World* world, const CampaignPart& part);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CAMPAIGN_PART_H_
