#include "props/run/conclude.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/grids_left.h"
#include "core/profile.h"
#include "core/vertex.h"
#include "props/authority.h"
#include "props/domains/domain.h"
#include "props/run/case_places.h"
#include "props/run/own_transform.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

// A near-edge recipe misses in about 1 case of 100 at worst (targets of one pixel, grids as coarse
// as pixels): four misses and no hit are no accident (10^-8), fewer say nothing.
constexpr std::uint64_t kFewestCasesToJudge = 4;

// Fewer cases that put a property to the test may miss a place by chance.
constexpr std::uint64_t kFewestCasesToReach = 100;

void AddSentence(std::string& message, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!message.empty()) message += "; ";
  message += sentence;
}

// "exercised in 2 of 120 cases, 118 refused"
std::string SoFar(const PropertyResult& result) {
  std::string text = "exercised in " + std::to_string(result.cases_exercised) + " of " +
                     std::to_string(result.cases) + " cases";
  if (result.cases_refused != 0) text += ", " + std::to_string(result.cases_refused) + " refused";
  return text;
}

// "all 31 cases with a sample on a horizontal edge": places whose cases were all refused.
std::string RefusedThroughout(const CountsOfPlaces& counts) {
  std::string text;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (counts[p].asked < kFewestCasesAtAPlace || counts[p].refused < counts[p].asked) continue;
    text += text.empty() ? "" : ", ";
    text +=
        "all " + std::to_string(counts[p].refused) + " cases with " + std::string(kCasePlaces[p]);
  }
  return text;
}

// What the subject refuses, if that is too much for a pass.
std::string RefusedText(const PropertyResult& result) {
  const bool too_much = RefusesTooMuch(result.refused_within_limits, result.cases_exercised);
  return too_much ? "too much" : RefusedThroughout(result.places);
}

bool ChangesItsFront(const PropertyResult& result) {
  return result.positive_fronts != 0 && result.negative_fronts != 0;
}

// Which side is the front, where that is left to the subject; else empty.
std::string FrontText(const PropertyResult& result) {
  if (ChangesItsFront(result)) {
    return "the subject contradicts itself: triangles of positive area are front in " +
           std::to_string(result.positive_fronts) + " cases and back in " +
           std::to_string(result.negative_fronts);
  }
  if (result.negative_fronts != 0) return "front is the side of negative area, for all triangles";
  return result.positive_fronts == 0 ? "" : "front is the side of positive area, for all triangles";
}

// A stated error by which most numbers of exchanged corners pass.
std::string WidthText(const PropertyResult& result) {
  if (!HasWideError(result)) return "";
  return "the stated error is so wide that exchanged corners, or the other plane, would pass on " +
         std::to_string(result.indistinct) + " of " +
         std::to_string(result.indistinct + result.exercised) + " values";
}

std::string SizeOf(const GridsOnTarget& grids) {
  return std::to_string(grids.width) + " x " + std::to_string(grids.height);
}

// The same scene on the same target, and no grid explains what each case saw of it.
std::string ChangedGridText(const PropertyResult& result) {
  const auto changed = std::ranges::find_if(
      result.grids, [](const GridsOnTarget& grids) { return grids.left.IsEmpty(); });
  if (changed == result.grids.end()) return "";
  return "the subject contradicts itself: of " + std::to_string(changed->cases) +
         " cases on targets of " + SizeOf(*changed) +
         " each shows a grid, and no grid is shown by all";
}

// The grids that are left, of all targets or by the size of target.
std::string GridText(const PropertyResult& result) {
  if (result.grids.empty()) return "";
  GridsLeft common = result.grids.front().left;
  for (const GridsOnTarget& grids : result.grids) common.Intersect(grids.left);
  const std::string number = std::to_string(result.grids.size());
  if (!common.IsEmpty()) {
    return "left of all grids: " + common.Text() + " subpixel bits, on targets of " + number +
           (result.grids.size() == 1 ? " size" : " sizes");
  }
  std::string text = "no grid explains targets of all " + number +
                     " sizes, and it is assumed that it may change with the size";
  for (const GridsOnTarget& one : result.grids) {
    for (const GridsOnTarget& other : result.grids) {
      GridsLeft both = one.left;
      both.Intersect(other.left);
      if (!both.IsEmpty()) continue;
      return text + ": " + one.left.Text() + " subpixel bits on " + SizeOf(one) + ", " +
             other.left.Text() + " on " + SizeOf(other);
    }
  }
  return text;
}

std::string DeadDomains(const SubjectInfo& info, const Property& property,
                        const PropertyResult& result) {
  if (result.domains.empty()) return "";
  const std::vector<const Domain*> domains = DomainsFor(info, property);
  std::string dead;
  for (std::size_t d = 0; d < domains.size(); ++d) {
    const auto& [drawn, near_edge] = result.domains[d];
    if (!domains[d]->near_edge || drawn < kFewestCasesToJudge) continue;
    if (near_edge.on_edge + near_edge.within_256 != 0) continue;
    dead += dead.empty() ? "no sample on or near an edge in near-edge domain " : ", ";
    dead += domains[d]->name;
  }
  return dead;
}

// Cases of domains that can reach a place.
std::uint64_t DrawnToReach(const std::vector<const Domain*>& domains, const PropertyResult& result,
                           bool (*can_reach)(const Domain&)) {
  std::uint64_t drawn = 0;
  for (std::size_t d = 0; d < domains.size(); ++d) {
    if (can_reach(*domains[d])) drawn += result.domains[d].drawn;
  }
  return drawn;
}

// Every coordinate that a sample has is one that a vertex can have.
bool HasSamplesOnLattice(const Profile& profile) {
  if (profile.transform || !profile.by_target_size.empty()) return false;
  const auto on_steps = [](double x, int bits) {
    return std::ldexp(x, bits) == std::floor(std::ldexp(x, bits));
  };
  const auto is_on = [&](double x) {
    return (profile.snap.IsNone() || on_steps(x, profile.snap.bits)) &&
           (!profile.fixed || on_steps(x, profile.fixed->fraction_bits));
  };
  return std::ranges::all_of(profile.pattern.locations,
                             [&](Point2 p) { return is_on(p.x) && is_on(p.y); });
}

bool IsReal(const Profile& profile) {
  return profile.snap.IsNone() && !profile.fixed && !profile.transform;
}

// What no case of a run reached, though its domains can.
std::string NotReached(const SubjectInfo& info, const Property& property,
                       const PropertyResult& result) {
  if (result.domains.empty() || result.cases_exercised < kFewestCasesToReach) return "";
  const std::vector<const Domain*> domains = DomainsFor(info, property);
  std::string missed;
  const auto require = [&](std::uint64_t reached, bool (*can_reach)(const Domain&),
                           std::string_view what) {
    const std::uint64_t drawn = DrawnToReach(domains, result, can_reach);
    if (reached != 0 || drawn < kFewestCasesAtAPlace) return;
    AddSentence(missed, "no case has " + std::string(what) + ", and " + std::to_string(drawn) +
                            " are of domains that can reach it");
  };
  const auto require_place = [&](CasePlace place, bool (*can_reach)(const Domain&)) {
    require(result.places[IndexOf(place)].asked, can_reach, kCasePlaces[IndexOf(place)]);
  };
  const auto ties = [](const Domain& d) { return d.ties; };
  if (HasSamplesOnLattice(info.profile)) {
    require(result.NearEdge().on_edge, ties, "a sample on an edge");
  }
  require_place(CasePlace::kPositiveArea, ties);
  require_place(CasePlace::kNegativeArea, ties);
  require_place(CasePlace::kClipped, [](const Domain& d) { return d.clip; });
  if (IsReal(info.profile) && result.end == End::kAllRun) {
    require(
        result.tiers.exact, [](const Domain& d) { return d.exact_tier; },
        "a sign that takes the oracle's exact tier");
  }
  if (!missed.empty()) AddSentence(missed, "run more cases, or correct the domain");
  return missed;
}

struct Conclusion {
  Outcome outcome = Outcome::kHolds;
  std::string message = {};
  bool says_how_far = false;  ///< the message has SoFar()
};

// Of a run in which nothing was violated, and no case lacks a verdict.
Conclusion OfCounters(const SubjectInfo& info, const Property& property,
                      const PropertyResult& result) {
  if (result.not_applicable == result.cases && (result.cases != 0 || result.domains.empty())) {
    return {Outcome::kNotApplicable, result.why_not};
  }
  if (const std::string refused = RefusedText(result); !refused.empty()) {
    return {Outcome::kInconclusive,
            "the subject refuses " + refused + ": " + SoFar(result) +
                "; the first refusal: " + result.why_refused,
            true};
  }
  if (ChangesItsFront(result)) return {Outcome::kInconclusive, FrontText(result)};
  if (std::string changed = ChangedGridText(result); !changed.empty()) {
    return {Outcome::kInconclusive, std::move(changed)};
  }
  const std::string dead = DeadDomains(info, property, result);
  const std::string missed = NotReached(info, property, result);
  if (dead.empty() && !missed.empty()) return {Outcome::kInconclusive, missed};
  Conclusion said;
  if (result.exercised == 0 || !dead.empty()) {
    said.outcome = Outcome::kNotExercised;
    if (result.exercised == 0) said.message = "no case exercised the property";
    AddSentence(said.message, dead);
    AddSentence(said.message, WidthText(result));
    return said;
  }
  if (result.cases_refused != 0) {
    said.message = "holds where it did not refuse: " + SoFar(result);
    said.says_how_far = true;
  }
  AddSentence(said.message, FrontText(result));
  AddSentence(said.message, GridText(result));
  AddSentence(said.message, WidthText(result));
  return said;
}

Conclusion ByEnd(const SubjectInfo& info, const Property& property, const PropertyResult& result) {
  const auto cut_short = [&result](std::string why) -> Conclusion {
    AddSentence(why, "nothing violated so far, " + SoFar(result));
    return {Outcome::kInconclusive, why, true};
  };
  switch (result.end) {
    case End::kAllRun:
    case End::kTimeUp:
      break;
    case End::kNotApplicable:
      return {Outcome::kNotApplicable, result.why};
    case End::kFailed:
      return {result.counterexample->outcome, result.counterexample->message};
    case End::kInconclusive:
      return cut_short(result.why);
    case End::kInterrupted:
      return cut_short("interrupted");
  }
  return OfCounters(info, property, result);
}

}  // namespace

PropertyResult NothingRun(const SubjectInfo& info, const Property& property, std::uint64_t seed,
                          const World* world) {
  PropertyResult result;
  result.property = property.name;
  result.subject = info.name;
  result.clause = property.clause;
  const Grounds grounds = AuthorityOf(property, info);
  result.authority = grounds.authority;
  for (const Clause* clause : grounds.clauses) result.required_by.emplace_back(clause->id);
  result.tolerance = property.tolerance;
  result.seed = seed;
  if (world == nullptr) {
    result.domains.resize(DomainsFor(info, property).size());
  } else {
    result.world = world->name;
    result.world_cases = world->cases;
  }
  return result;
}

void AddCase(std::size_t place, const Case& c, const Verdict& verdict, PropertyResult& result) {
  result.AddCase(verdict);
  const CaseEvidence evidence = EvidenceOfCase(SeenCase(c));
  if (!result.domains.empty()) {
    DomainCounts& domain = result.domains[place];
    ++domain.drawn;
    domain.near_edge += evidence.near_edge;
  }
  if (verdict.grids) {
    const Scene& scene = c.scene;
    AddGrids({{.width = scene.width,
               .height = scene.height,
               .samples = c.profile.pattern.samples(),
               .clip_space = scene.clip_space,
               .cases = 1,
               .left = *verdict.grids}},
             result.grids);
  }
  const bool is_refused = verdict.outcome == Outcome::kRefused && WithinLimits(c.scene, c.profile);
  if (is_refused && result.refused_within_limits++ == 0) result.why_refused = verdict.message;
  if (!is_refused && verdict.exercised == 0) return;
  for (std::size_t p = 0; p < result.places.size(); ++p) {
    if (!evidence.places[p]) continue;
    ++result.places[p].asked;
    if (is_refused) ++result.places[p].refused;
  }
}

void Conclude(const SubjectInfo& info, const Property& property, PropertyResult& result) {
  auto [outcome, message, says_how_far] = ByEnd(info, property, result);
  if (result.world.empty() && result.end != End::kNotApplicable) {
    AddSentence(message, LeftOutDomains(info, property));
  }
  result.outcome = outcome;
  result.message = message;
  result.message_counts_refused = says_how_far;
}

}  // namespace rasterproof::props
