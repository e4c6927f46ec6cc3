#include "props/catalog/fragment_depth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/fragment_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict FragmentDepthFollowsItsWeights(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskFragments(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : SomeFragments(subject, c)) {
    double bound = f.depth_tolerance;
    exact::Rational by_weights;
    for (std::size_t i = 0; i < 3; ++i) bound += f.weight_tolerances[i] * std::fabs(f.z[i]);
    if (!Claims(bound)) continue;
    ++exercised;
    const std::string claim = "the depth of a fragment is not what its weights give";
    if (!std::ranges::all_of(f.weights, [](double x) { return std::isfinite(x); })) {
      return FragmentViolation(f, -1, exercised, claim, WeightsText(f), "finite weights");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      by_weights += exact::Rational(f.weights[i]) * exact::Rational(f.z[i]);
    }
    const Distance distance = CompareWithExact(f.depth, by_weights, bound);
    if (!distance.within) {
      return FragmentViolation(f, -1, exercised, claim, HexText(f.depth),
                               HexText(by_weights.ToDouble()) + " within " + HexText(bound));
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
