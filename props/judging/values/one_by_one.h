// Answers of a property that are judged one by one, until one violates it.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_ONE_BY_ONE_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_ONE_BY_ONE_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/verdict.h"

namespace rasterproof::props {

/// Returns the first violation among `judge(0)` to `judge(n - 1)`, or that all hold; with what was
/// exercised until then and the largest ratio of all.
template <class Judge>
Verdict OneByOne(std::size_t n, const Judge& judge) {
  std::uint64_t exercised = 0;
  std::uint64_t indistinct = 0;
  double worst = 0;
  for (std::size_t k = 0; k < n; ++k) {
    Verdict verdict = judge(k);
    exercised += verdict.exercised;
    indistinct += verdict.indistinct;
    worst = std::max(worst, verdict.worst_ratio);
    if (verdict.outcome != Outcome::kViolated) continue;
    verdict.exercised = exercised;
    return verdict;
  }
  Verdict held = Verdict::Held(exercised, worst);
  held.indistinct = indistinct;
  return held;
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_ONE_BY_ONE_H_
