// Reordering the vertices reorders the weights, up to the bounds claimed for both orders.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/weight_queries.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

using Order = std::array<std::size_t, 3>;
constexpr std::array<Order, 5> kOrders{{{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  const WeightEvaluator& evaluator = *subject.Weights();
  std::uint64_t exercised = 0;
  for (const auto& [q, form, weights, bounds] : WeightsAtQueries(evaluator, c)) {
    const Point2 p = q.place.at;
    for (const Order& order : kOrders) {
      const std::array<Point2, 3> v{q.v[order[0]], q.v[order[1]], q.v[order[2]]};
      const std::array<double, 3> reordered = evaluator.Weights(form, v, p);
      const std::array<double, 3> reordered_bounds = evaluator.WeightErrorBounds(form, v, p);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = order[k];
        if (!Claims(bounds[i]) || !Claims(reordered_bounds[k])) continue;
        ++exercised;
        if (AgreeWithin(reordered[k], weights[i], -1, reordered_bounds[k], bounds[i])) continue;
        return WeightViolation(
            q, static_cast<int>(i), exercised,
            "weight (" + std::string(FormName(form)) + ") does not follow its vertex",
            HexText(reordered[k]) + " as entry " + std::to_string(k),
            HexText(weights[i]) + " within " + HexText(bounds[i] + reordered_bounds[k]));
      }
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kWeightsFollowTheirVertices{
    .name = "WeightsFollowTheirVertices",
    .group = "barycentric",
    .clause = "A weight belongs to its vertex, in whatever order the vertices are told.",
    .precondition = kWeightValues,
    .tolerance = "the sum of both proven WeightErrorBounds",
    .domains = kWeights,
    .check = Judge,
};

}  // namespace rasterproof::props
