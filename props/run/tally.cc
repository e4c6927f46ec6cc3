#include "props/run/tally.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "core/profile.h"
#include "props/authority.h"
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

Tally::Tally(const Subject& subject, const Property& property, std::uint64_t seed,
             const World* world)
    : domains_(world == nullptr ? DomainsFor(subject.Info(), property)
                                : std::vector<const Domain*>{}),
      drawn_(domains_.size()),
      near_edge_(domains_.size()) {
  result_.property = property.name;
  result_.subject = subject.Info().name;
  result_.clause = property.clause;
  TellGrounds(AuthorityOf(property, subject.Info().profile), result_);
  result_.tolerance = property.tolerance;
  result_.seed = seed;
  if (world == nullptr) {
    left_out_ = LeftOutDomains(subject.Info(), property);
  } else {
    result_.world = world->name;
    result_.world_cases = world->cases;
  }
}

void Tally::CountNearEdgesOf(const Case& c, std::size_t domain) {
  const NearEdgeCounts counts = CountNearEdges(SeenCase(c));
  ++drawn_[domain];
  Add(near_edge_[domain], counts);
  Add(result_.near_edge, counts);
}

void Tally::AddCase(std::uint64_t number, const Case& c, const Verdict& verdict) {
  ++result_.cases;
  result_.exercised += verdict.exercised;
  if (verdict.exercised != 0) ++result_.cases_exercised;
  result_.worst_ratio = std::max(result_.worst_ratio, verdict.worst_ratio);
  if (!domains_.empty()) CountNearEdgesOf(c, number % domains_.size());
  result_.not_judged += verdict.not_judged;
  if (verdict.outcome == Outcome::kRefused) {
    ++result_.cases_refused;
    if (WithinLimits(c.scene, c.profile) && refused_within_limits_++ == 0) {
      why_refused_ = verdict.message;
    }
  }
  if (verdict.outcome != Outcome::kNotApplicable) return;
  ++not_applicable_;
  if (why_not_.empty()) why_not_ = verdict.message;
}

PropertyResult Tally::Concluded() const {
  PropertyResult result = result_;
  if (not_applicable_ == result.cases && (result.cases != 0 || domains_.empty())) {
    result.outcome = Outcome::kNotApplicable;
    result.message = why_not_;
    AddSentence(result.message, left_out_);
    return result;
  }
  const auto refused = static_cast<double>(refused_within_limits_);
  const auto asked = static_cast<double>(refused_within_limits_ + result.cases_exercised);
  if (refused > kMostRefusedShare * asked) {
    result.outcome = Outcome::kInconclusive;
    AddSentence(result.message, "the subject refuses too much: " + SoFar() +
                                    "; the first refusal: " + why_refused_);
    AddSentence(result.message, left_out_);
    return result;
  }
  const std::string dead = DeadDomains();
  const bool holds = result.exercised != 0 && dead.empty();
  result.outcome = holds ? Outcome::kHolds : Outcome::kNotExercised;
  if (result.exercised == 0) AddSentence(result.message, "no case put the property to the test");
  AddSentence(result.message, dead);
  if (holds && result.cases_refused != 0) {
    AddSentence(result.message, "holds where it did not refuse: " + SoFar());
  }
  AddSentence(result.message, left_out_);
  return result;
}

PropertyResult Tally::NotApplicable(const std::string& why) const {
  PropertyResult result = result_;
  result.outcome = Outcome::kNotApplicable;
  result.message = why;
  return result;
}

PropertyResult Tally::Inconclusive(const std::string& why) const {
  PropertyResult result = result_;
  result.outcome = Outcome::kInconclusive;
  AddSentence(result.message, why);
  AddSentence(result.message, "nothing violated so far, " + SoFar());
  AddSentence(result.message, left_out_);
  return result;
}

PropertyResult Tally::Interrupted() const { return Inconclusive("interrupted"); }

PropertyResult Tally::Failed(Counterexample found, std::string failing_case) const {
  PropertyResult result = result_;
  result.outcome = found.outcome;
  result.failing_case = std::move(failing_case);
  result.counterexample = std::move(found.value);
  result.verdict = std::move(found.verdict);
  result.message = found.message;
  AddSentence(result.message, left_out_);
  return result;
}

// "exercised in 2 of 120 cases, 118 refused"
std::string Tally::SoFar() const {
  std::string text = "exercised in " + std::to_string(result_.cases_exercised) + " of " +
                     std::to_string(result_.cases) + " cases";
  if (result_.cases_refused != 0) text += ", " + std::to_string(result_.cases_refused) + " refused";
  return text;
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
