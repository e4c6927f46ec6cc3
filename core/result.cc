#include "core/result.h"

#include <algorithm>

namespace rasterproof {

void Counts::AddCase(const Verdict& verdict) {
  Add({1, verdict.exercised != 0 ? 1U : 0U, verdict.exercised,
       verdict.outcome == Outcome::kRefused ? 1U : 0U, verdict.not_judged, verdict.worst_ratio});
}

void Counts::Add(const Counts& more) {
  cases += more.cases;
  cases_exercised += more.cases_exercised;
  exercised += more.exercised;
  cases_refused += more.cases_refused;
  not_judged += more.not_judged;
  worst_ratio = std::max(worst_ratio, more.worst_ratio);
}

}  // namespace rasterproof
