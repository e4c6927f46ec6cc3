// One subject's certificate.
#include "tool/certify.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "core/result.h"
#include "exact/edge.h"
#include "exact/environment.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/contract_evidence.h"
#include "tool/evidence.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// Whether a result of a run that was interrupted stands: subjects outside are ended by it, so that
// only what was seen to fail, and fails again, is known.
bool Stands(const PropertyResult& result) {
  return result.outcome == Outcome::kViolated && result.verdict &&
         result.verdict->outcome == Outcome::kViolated;
}

void TestProperties(Subject& subject, const CertifyOptions& options,
                    report::Certificate& certificate) {
  props::Pace pace;
  for (const props::Property& property : props::Catalog()) {
    props::CampaignOptions campaign;
    campaign.seed = options.campaign.seed;
    campaign.cases = options.campaign.cases;
    campaign.seconds = options.campaign.seconds;
    campaign.time_limit = TimeLimitOf(subject);
    campaign.stop = &Interrupted;
    campaign.pace = &pace;
    PropertyResult result = props::RunCampaign(subject, property, campaign);
    certificate.interrupted = Interrupted();
    if (!certificate.interrupted || Stands(result)) certificate.tested.push_back(std::move(result));
    if (certificate.interrupted) return;
  }
  const props::ContractEvidence evidence =
      props::EvidenceOfContract(subject.Info(), certificate.tested);
  if (!evidence.is_exercised) certificate.contract_untested = evidence.why;
}

std::map<std::string, std::string> DescribeEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  return {{"compiler", environment.compiler},
          {"flags", environment.flags},
          {"rounding", environment.round_to_nearest ? "to nearest" : "directed"},
          {"subnormals", environment.subnormals_kept ? "kept" : "flushed"},
          {"contraction", environment.contraction_off ? "off" : "on"}};
}

}  // namespace

report::Certificate CertifySubject(const std::string& name, const CertifyOptions& options,
                                   MeasuredScenes& scenes) {
  const exact::TierScope scope;
  const std::unique_ptr<Subject> subject = MakeSubject(name);
  report::Certificate certificate;
  certificate.tool_version = RASTERPROOF_VERSION;
  certificate.subject = subject->Info();
  certificate.command = options.command;
  certificate.environment = DescribeEnvironment();
  certificate.seed = options.campaign.seed;
  certificate.proved = ProvedOf(certificate.subject);
  TestProperties(*subject, options, certificate);
  MeasureScenes(*subject, scenes, certificate);
  const exact::TierCounts tiers = scope.Counts();
  certificate.oracle_tiers = {{"filter", tiers.filter},
                              {"stable", tiers.stable},
                              {"exact", tiers.exact},
                              {"symbolic", tiers.symbolic}};
  return certificate;
}

}  // namespace rasterproof::tool
