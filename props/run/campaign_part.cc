#include "props/run/campaign_part.h"

#include <cstdint>
#include <span>

#include "core/result.h"
#include "core/subject.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/tally.h"

namespace rasterproof::props {
namespace {

PropertyResult Concluded(const Tally& tally, const CampaignPart& last) {
  switch (last.end) {
    case End::kAllRun:
    case End::kTimeUp:
      break;
    case End::kNotApplicable:
      return tally.NotApplicable(last.why);
    case End::kFailed:
      return tally.Failed(*last.found, last.failing_case);
    case End::kInconclusive:
      return tally.Inconclusive(last.why);
    case End::kInterrupted:
      return tally.Interrupted();
  }
  return tally.Concluded();
}

}  // namespace

PropertyResult ResultOf(const Subject& subject, const Property& property, std::uint64_t seed,
                        const World* world, std::span<const CampaignPart> parts) {
  Tally tally(subject, property, seed, world);
  double seconds = 0;
  const CampaignPart* last = nullptr;
  for (const CampaignPart& part : parts) {
    seconds += part.seconds;
    if (last != nullptr && EndsTheCampaign(*last)) continue;
    tally.AddSums(part.sums);
    last = &part;
  }
  PropertyResult result = last == nullptr ? tally.Concluded() : Concluded(tally, *last);
  result.seconds = seconds;
  return result;
}

}  // namespace rasterproof::props
