// One subject's certificate.
#include "tool/certify.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "core/result.h"
#include "exact/edge.h"
#include "exact/environment.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/contract_evidence.h"
#include "tool/asked.h"
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

void Add(report::Certificate& whole, const report::Certificate& part) {
  whole.tested.insert(whole.tested.end(), part.tested.begin(), part.tested.end());
  whole.measured.insert(whole.measured.end(), part.measured.begin(), part.measured.end());
  whole.replay.insert(part.replay.begin(), part.replay.end());
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

Certification::Certification(const AskedSubject& subject, const CertifyOptions& options,
                             MeasuredScenes& scenes)
    : subject_(subject), info_(subject.Make()->Info()), options_(options), scenes_(scenes) {
  for (const props::Property& property : props::Catalog()) tests_.push_back({&property, nullptr});
  for (const std::string& name : options.worlds) {
    const props::World* world = props::FindWorld(name);
    for (const std::string_view property : world->properties) {
      tests_.push_back({props::FindProperty(property), world});
    }
  }
  parts_.resize(tests_.size() + scenes.size());
}

bool Certification::TakesLong(std::size_t part) const {
  return part >= tests_.size() || tests_[part].world != nullptr ||
         tests_[part].property->takes_long;
}

void Certification::Do(std::size_t part, Subject& subject) {
  Part& mine = parts_[part];
  mine.is_begun = true;
  const exact::TierScope scope;
  if (part < tests_.size()) {
    RunTest(subject, tests_[part], mine.found);
  } else {
    MeasureOne(subject, *scenes_[part - tests_.size()], mine.found);
  }
  mine.tiers = scope.Counts();
  mine.is_done = true;
}

void Certification::RunTest(Subject& subject, const Test& test, report::Certificate& certificate) {
  props::CampaignOptions campaign;
  campaign.seed = options_.campaign.seed;
  campaign.world = test.world;
  campaign.cases = test.world != nullptr ? test.world->cases : options_.campaign.cases;
  campaign.seconds = options_.campaign.seconds;
  campaign.time_limit = TimeLimitOf(subject);
  if (IsOutside(info_.name)) campaign.afresh = [&] { return subject_.Make(); };
  campaign.stop = &Interrupted;
  campaign.pace = &pace_;
  PropertyResult result = props::RunCampaign(subject, *test.property, campaign);
  certificate.interrupted = Interrupted();
  if (!certificate.interrupted || Stands(result)) certificate.tested.push_back(std::move(result));
}

bool Certification::IsBegun() const { return std::ranges::any_of(parts_, &Part::is_begun); }

bool Certification::IsDone() const { return std::ranges::all_of(parts_, &Part::is_done); }

report::Certificate Certification::Result() const {
  report::Certificate certificate;
  certificate.tool_version = RASTERPROOF_VERSION;
  certificate.subject = info_;
  certificate.command = options_.command;
  certificate.environment = DescribeEnvironment();
  certificate.seed = options_.campaign.seed;
  certificate.fail_on = options_.fail_on;
  certificate.proved = ProvedOf(info_);
  exact::TierCounts tiers;
  const auto add = [&](const Part& part) {
    certificate.interrupted = certificate.interrupted || part.found.interrupted || !part.is_done;
    Add(certificate, part.found);
    tiers += part.tiers;
  };
  const auto scenes = parts_.begin() + static_cast<std::ptrdiff_t>(tests_.size());
  std::for_each(parts_.begin(), scenes, add);
  if (!certificate.interrupted) {
    const props::ContractEvidence evidence = props::EvidenceOfContract(info_, certificate.tested);
    if (!evidence.is_exercised) certificate.contract_untested = evidence.why;
  }
  std::for_each(scenes, parts_.end(), add);
  certificate.oracle_tiers = {{"filter", tiers.filter},
                              {"stable", tiers.stable},
                              {"exact", tiers.exact},
                              {"symbolic", tiers.symbolic}};
  return certificate;
}

}  // namespace rasterproof::tool
