#include "props/catalog/fragment_weights.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/fragment_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict FragmentWeightsStayWithinTheirError(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskFragments(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : SomeFragments(subject, c)) {
    const std::array<exact::Rational, 3> exact_weights = ExactWeights(f.query);
    for (std::size_t i = 0; i < 3; ++i) {
      const double bound = f.weight_tolerances[i];
      if (!Claims(bound)) continue;
      ++exercised;
      const Distance distance = CompareWithExact(f.weights[i], exact_weights[i], bound);
      if (!distance.within) {
        return FragmentViolation(f, static_cast<int>(i), exercised,
                                 "a weight of a fragment is off by more than its error",
                                 WeightsText(f),
                                 exact_weights[i].ToString() + " within " + HexText(bound) +
                                     " for vertex " + std::to_string(i));
      }
      worst = std::max(worst, distance.ratio);
    }
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
