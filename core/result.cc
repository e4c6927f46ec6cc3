#include "core/result.h"

#include <algorithm>
#include <cstddef>

namespace rasterproof {

NearEdgeCounts& NearEdgeCounts::operator+=(const NearEdgeCounts& more) {
  samples += more.samples;
  on_edge += more.on_edge;
  within_1 += more.within_1;
  within_16 += more.within_16;
  within_256 += more.within_256;
  return *this;
}

void PropertyResult::AddCase(const Verdict& verdict) {
  ++cases;
  if (verdict.exercised != 0) ++cases_exercised;
  exercised += verdict.exercised;
  not_judged += verdict.not_judged;
  worst_ratio = std::max(worst_ratio, verdict.worst_ratio);
  if (verdict.front_sign) ++(*verdict.front_sign > 0 ? positive_fronts : negative_fronts);
  if (verdict.outcome == Outcome::kRefused) ++cases_refused;
  if (verdict.outcome == Outcome::kNotApplicable && not_applicable++ == 0) {
    why_not = verdict.message;
  }
}

PropertyResult& PropertyResult::operator+=(const PropertyResult& next) {
  seconds += next.seconds;
  if (end != End::kAllRun) return *this;
  cases += next.cases;
  cases_exercised += next.cases_exercised;
  exercised += next.exercised;
  cases_refused += next.cases_refused;
  not_judged += next.not_judged;
  worst_ratio = std::max(worst_ratio, next.worst_ratio);
  positive_fronts += next.positive_fronts;
  negative_fronts += next.negative_fronts;
  domains.resize(std::max(domains.size(), next.domains.size()));
  for (std::size_t d = 0; d < next.domains.size(); ++d) {
    domains[d].drawn += next.domains[d].drawn;
    domains[d].near_edge += next.domains[d].near_edge;
  }
  if (not_applicable == 0) why_not = next.why_not;
  not_applicable += next.not_applicable;
  if (refused_within_limits == 0) why_refused = next.why_refused;
  refused_within_limits += next.refused_within_limits;
  for (std::size_t p = 0; p < places.size(); ++p) {
    places[p].asked += next.places[p].asked;
    places[p].refused += next.places[p].refused;
  }
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
