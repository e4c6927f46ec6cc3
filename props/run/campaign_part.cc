#include "props/run/campaign_part.h"

#include <cstdint>
#include <utility>

#include "core/result.h"
#include "core/subject.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/tally.h"

namespace rasterproof::props {
namespace {

PropertyResult Concluded(const Tally& tally, const CampaignPart& part) {
  switch (part.end) {
    case End::kAllRun:
    case End::kTimeUp:
      break;
    case End::kNotApplicable:
      return tally.NotApplicable(part.why);
    case End::kFailed:
      return tally.Failed(*part.found, part.failing_case);
    case End::kInconclusive:
      return tally.Inconclusive(part.why);
    case End::kInterrupted:
      return tally.Interrupted();
  }
  return tally.Concluded();
}

}  // namespace

void Add(CampaignPart& part, const CampaignPart& next) {
  const double seconds = part.seconds + next.seconds;
  if (!EndsTheCampaign(part)) {
    Sums sums = std::move(part.sums);
    sums.Add(next.sums);
    part = next;
    part.sums = std::move(sums);
  }
  part.seconds = seconds;
}

PropertyResult ResultOf(const Subject& subject, const Property& property, std::uint64_t seed,
                        const World* world, const CampaignPart& part) {
  Tally tally(subject, property, seed, world);
  tally.AddSums(part.sums);
  PropertyResult result = Concluded(tally, part);
  result.seconds = part.seconds;
  return result;
}

}  // namespace rasterproof::props
