#include "core/result.h"

#include <algorithm>
#include <cstddef>

namespace rasterproof {

void PropertyResult::AddCase(const Verdict& verdict) {
  ++cases;
  if (verdict.exercised != 0) ++cases_exercised;
  exercised += verdict.exercised;
  not_judged += verdict.not_judged;
  in_gaps += verdict.in_gaps;
  indistinct += verdict.indistinct;
  worst_ratio = std::max(worst_ratio, verdict.worst_ratio);
  if (verdict.front_sign) ++(*verdict.front_sign > 0 ? positive_fronts : negative_fronts);
  if (verdict.outcome == Outcome::kRefused) ++cases_refused;
  if (verdict.outcome == Outcome::kNotApplicable && not_applicable++ == 0) {
    why_not = verdict.message;
  }
}

DrawsJudged& DrawsJudged::operator+=(const DrawsJudged& more) {
  window += more.window;
  clip += more.clip;
  largest_target = std::max(largest_target, more.largest_target);
  return *this;
}

PropertyResult& PropertyResult::operator+=(const PropertyResult& next) {
  seconds += next.seconds;
  if (end != End::kAllRun) return *this;
  if (not_applicable == 0) why_not = next.why_not;
  if (refused_within_limits == 0) why_refused = next.why_refused;
  AddCounters(kCaseCounters, next, *this);
  worst_ratio = std::max(worst_ratio, next.worst_ratio);
  AddGrids(next.grids, grids);
  domains.resize(std::max(domains.size(), next.domains.size()));
  for (std::size_t d = 0; d < next.domains.size(); ++d) {
    domains[d].drawn += next.domains[d].drawn;
    domains[d].near_edge += next.domains[d].near_edge;
  }
  for (std::size_t p = 0; p < places.size(); ++p) {
    AddCounters(kPlaceCounters, next.places[p], places[p]);
  }
  draws += next.draws;
  end = next.end;
  tiers += next.tiers;
  if (end != End::kAllRun) tiers = {};
  why = next.why;
  counterexample = next.counterexample;
  return *this;
}

NearEdgeCounts PropertyResult::NearEdge() const {
  NearEdgeCounts sum;
  for (const DomainCounts& domain : domains) sum += domain.near_edge;
  return sum;
}

}  // namespace rasterproof
