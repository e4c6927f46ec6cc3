#include "props/catalog/interpolation_deltas.h"

#include <cstdint>
#include <optional>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/interpolation_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict DepthByDeltasEqualsDepthByWeights(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  const WeightEvaluator& evaluator = *subject.Weights();
  std::uint64_t exercised = 0;
  for (const InterpolationQuery& q : SomeInterpolations(c)) {
    const Point2 p = q.at.place.at;
    const auto value = [&](InterpolationForm form) {
      return evaluator.Interpolate(form, q.corners, q.attribute, p);
    };
    const auto bound = [&](InterpolationForm form) {
      return evaluator.InterpolationErrorBound(form, q.corners, q.attribute, p);
    };
    const double weights_bound = bound(InterpolationForm::kWeights);
    const double deltas_bound = bound(InterpolationForm::kDeltas);
    if (!Claims(weights_bound) || !Claims(deltas_bound)) continue;
    ++exercised;
    const double by_weights = value(InterpolationForm::kWeights);
    const double by_deltas = value(InterpolationForm::kDeltas);
    if (AgreeWithin(by_deltas, by_weights, -1, deltas_bound, weights_bound)) continue;
    return WeightViolation(
        q.at, -1, exercised, "depth by deltas differs from depth by weights",
        HexText(by_deltas) + " by deltas",
        HexText(by_weights) + " by weights, within " + HexText(deltas_bound + weights_bound));
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
