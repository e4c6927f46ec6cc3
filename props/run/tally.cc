#include "props/run/tally.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "props/run/campaign.h"
#include "props/run/near_edge.h"
#include "props/run/own_transform.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

// A near-edge recipe misses in about 1 case of 100 at worst (targets of one pixel, grids as coarse
// as pixels): four misses and no hit are no accident (10^-8), fewer say nothing.
constexpr std::uint64_t kFewestCasesToJudge = 4;

void AddSentence(std::string& message, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!message.empty()) message += "; ";
  message += sentence;
}

}  // namespace

Tally::Tally(const Subject& subject, const Property& property, std::uint64_t seed)
    : domains_(DomainsFor(subject.Info(), property)),
      drawn_(domains_.size()),
      near_edge_(domains_.size()) {
  result_.property = property.name;
  result_.subject = subject.Info().name;
  result_.clause = property.clause;
  result_.tolerance = property.tolerance;
  result_.seed = seed;
  result_.message = LeftOutDomains(subject.Info(), property);
}

void Tally::AddCase(std::size_t domain, const Case& c, const Verdict& verdict) {
  ++result_.cases;
  result_.exercised += verdict.exercised;
  result_.not_judged += verdict.not_judged;
  if (verdict.exercised != 0) ++result_.cases_exercised;
  result_.worst_ratio = std::max(result_.worst_ratio, verdict.worst_ratio);
  const NearEdgeCounts counts = CountNearEdges(SeenCase(c));
  ++drawn_[domain];
  Add(near_edge_[domain], counts);
  Add(result_.near_edge, counts);
  if (verdict.outcome != Outcome::kNotApplicable) return;
  ++not_applicable_;
  if (why_not_.empty()) why_not_ = verdict.message;
}

PropertyResult Tally::Concluded() const {
  PropertyResult result = result_;
  if (not_applicable_ == result.cases && (result.cases != 0 || domains_.empty())) {
    result.outcome = Outcome::kNotApplicable;
    AddSentence(result.message, why_not_);
    return result;
  }
  const std::string dead = DeadDomains();
  const bool holds = result.exercised != 0 && dead.empty();
  result.outcome = holds ? Outcome::kHolds : Outcome::kNotExercised;
  if (result.exercised == 0) AddSentence(result.message, "no case put the claim to the test");
  AddSentence(result.message, dead);
  return result;
}

PropertyResult Tally::Violated(Subject& subject, const Property& property, Case minimal,
                               std::uint64_t failing_case) const {
  PropertyResult result = result_;
  result.outcome = Outcome::kViolated;
  result.failing_case = failing_case;
  result.verdict = RunCase(subject, property, minimal);
  result.counterexample = std::move(minimal);
  AddSentence(result.message,
              result.verdict->outcome == Outcome::kViolated
                  ? result.verdict->message
                  : "the subject is not deterministic: its counterexample does not fail again");
  return result;
}

std::string Tally::DeadDomains() const {
  std::string dead;
  for (std::size_t d = 0; d < domains_.size(); ++d) {
    const NearEdgeCounts& counts = near_edge_[d];
    if (!domains_[d]->near_edge || drawn_[d] < kFewestCasesToJudge) continue;
    if (counts.on_edge + counts.within_256 != 0) continue;
    dead += dead.empty() ? "no sample on or near an edge in near-edge domain " : ", ";
    dead += domains_[d]->name;
  }
  return dead;
}

}  // namespace rasterproof::props
