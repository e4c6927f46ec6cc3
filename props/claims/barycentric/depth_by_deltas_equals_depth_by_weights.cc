// z0 + l1 (z1 - z0) + l2 (z2 - z0) and l0 z0 + l1 z1 + l2 z2 agree up to the sum of their bounds.
#include <cstdint>
#include <optional>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/interpolation_queries.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
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

}  // namespace

constinit const Property kDepthByDeltasEqualsDepthByWeights{
    .name = "DepthByDeltasEqualsDepthByWeights",
    .group = "barycentric",
    .clause =
        "z0 + l1 (z1 - z0) + l2 (z2 - z0) is l0 z0 + l1 z1 + l2 z2 because the weights sum "
        "to one.",
    .precondition = kWeightValues,
    .tolerance = "the sum of both proven InterpolationErrorBounds",
    .domains = kWeights,
    .check = Judge,
};

}  // namespace rasterproof::props
