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

void Sums::Add(const Sums& next) {
  Counts::Add(next);
  positive_fronts += next.positive_fronts;
  negative_fronts += next.negative_fronts;
  drawn.resize(std::max(drawn.size(), next.drawn.size()));
  near_edge.resize(drawn.size());
  for (std::size_t d = 0; d < next.drawn.size(); ++d) {
    drawn[d] += next.drawn[d];
    props::Add(near_edge[d], next.near_edge[d]);
  }
  not_applicable += next.not_applicable;
  if (why_not.empty()) why_not = next.why_not;
  if (refused_within_limits == 0) why_refused = next.why_refused;
  refused_within_limits += next.refused_within_limits;
  props::Add(places, next.places);
}

Tally::Tally(const Subject& subject, const Property& property, std::uint64_t seed,
             const World* world)
    : domains_(world == nullptr ? DomainsFor(subject.Info(), property)
                                : std::vector<const Domain*>{}) {
  sums_.drawn.resize(domains_.size());
  sums_.near_edge.resize(domains_.size());
  words_.property = property.name;
  words_.subject = subject.Info().name;
  words_.clause = property.clause;
  SetGrounds(AuthorityOf(property, subject.Info().profile), words_);
  words_.tolerance = property.tolerance;
  words_.seed = seed;
  if (world == nullptr) {
    left_out_ = LeftOutDomains(subject.Info(), property);
  } else {
    words_.world = world->name;
    words_.world_cases = world->cases;
  }
}

void Tally::CountPlacesOf(const CasePlaces& places, bool is_refused) {
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (!places[p]) continue;
    ++sums_.places[p].asked;
    if (is_refused) ++sums_.places[p].refused;
  }
}

void Tally::AddCase(std::uint64_t number, const Case& c, const Verdict& verdict) {
  sums_.AddCase(verdict);
  const CaseEvidence evidence = EvidenceOfCase(SeenCase(c));
  if (!domains_.empty()) {
    const std::size_t domain = number % domains_.size();
    ++sums_.drawn[domain];
    Add(sums_.near_edge[domain], evidence.near_edge);
  }
  if (verdict.front_sign)
    ++(*verdict.front_sign > 0 ? sums_.positive_fronts : sums_.negative_fronts);
  const bool is_refused = verdict.outcome == Outcome::kRefused && WithinLimits(c.scene, c.profile);
  if (is_refused && sums_.refused_within_limits++ == 0) sums_.why_refused = verdict.message;
  if (is_refused || verdict.exercised != 0) CountPlacesOf(evidence.places, is_refused);
  if (verdict.outcome != Outcome::kNotApplicable) return;
  ++sums_.not_applicable;
  if (sums_.why_not.empty()) sums_.why_not = verdict.message;
}

PropertyResult Tally::Counted() const {
  PropertyResult result = words_;
  static_cast<Counts&>(result) = sums_;
  for (const NearEdgeCounts& counts : sums_.near_edge) Add(result.near_edge, counts);
  return result;
}

PropertyResult Tally::Concluded() const {
  PropertyResult result = Counted();
  if (sums_.not_applicable == result.cases && (result.cases != 0 || domains_.empty())) {
    result.outcome = Outcome::kNotApplicable;
    result.message = sums_.why_not;
    AddSentence(result.message, left_out_);
    return result;
  }
  const auto refused = static_cast<double>(sums_.refused_within_limits);
  const auto asked = static_cast<double>(sums_.refused_within_limits + result.cases_exercised);
  if (refused > kMostRefusedShare * asked) {
    result.outcome = Outcome::kInconclusive;
    AddSentence(result.message, "the subject refuses too much: " + SoFar() +
                                    "; the first refusal: " + sums_.why_refused);
    AddSentence(result.message, left_out_);
    return result;
  }
  if (sums_.positive_fronts != 0 && sums_.negative_fronts != 0) {
    result.outcome = Outcome::kInconclusive;
    AddSentence(result.message, FrontText());
    AddSentence(result.message, left_out_);
    return result;
  }
  const std::string unasked = RefusedThroughout(sums_.places);
  if (!unasked.empty()) {
    result.outcome = Outcome::kInconclusive;
    AddSentence(result.message, "the subject refuses " + unasked + ": " + SoFar() +
                                    "; the first refusal: " + sums_.why_refused);
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
  if (holds) AddSentence(result.message, FrontText());
  AddSentence(result.message, left_out_);
  return result;
}

PropertyResult Tally::NotApplicable(const std::string& why) const {
  PropertyResult result = Counted();
  result.outcome = Outcome::kNotApplicable;
  result.message = why;
  return result;
}

PropertyResult Tally::Inconclusive(const std::string& why) const {
  PropertyResult result = Counted();
  result.outcome = Outcome::kInconclusive;
  AddSentence(result.message, why);
  AddSentence(result.message, "nothing violated so far, " + SoFar());
  AddSentence(result.message, left_out_);
  return result;
}

PropertyResult Tally::Interrupted() const { return Inconclusive("interrupted"); }

PropertyResult Tally::Failed(Counterexample found, std::string failing_case) const {
  PropertyResult result = Counted();
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
  std::string text = "exercised in " + std::to_string(sums_.cases_exercised) + " of " +
                     std::to_string(sums_.cases) + " cases";
  if (sums_.cases_refused != 0) text += ", " + std::to_string(sums_.cases_refused) + " refused";
  return text;
}

std::string Tally::FrontText() const {
  const std::string positive = std::to_string(sums_.positive_fronts);
  const std::string negative = std::to_string(sums_.negative_fronts);
  if (sums_.positive_fronts != 0 && sums_.negative_fronts != 0) {
    return "the subject changes its answer: the same triangle, of positive area, is front in " +
           positive + " cases and back in " + negative;
  }
  if (sums_.negative_fronts != 0) return "front is the side of negative area, for all triangles";
  return sums_.positive_fronts == 0 ? "" : "front is the side of positive area, for all triangles";
}

std::string Tally::DeadDomains() const {
  std::string dead;
  for (std::size_t d = 0; d < domains_.size(); ++d) {
    const NearEdgeCounts& counts = sums_.near_edge[d];
    if (!domains_[d]->near_edge || sums_.drawn[d] < kFewestCasesToJudge) continue;
    if (counts.on_edge + counts.within_256 != 0) continue;
    dead += dead.empty() ? "no sample on or near an edge in near-edge domain " : ", ";
    dead += domains_[d]->name;
  }
  return dead;
}

}  // namespace rasterproof::props
