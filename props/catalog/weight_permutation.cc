#include "props/catalog/weight_permutation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/weight_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

using Order = std::array<std::size_t, 3>;
constexpr std::array<Order, 5> kOrders{{{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

}  // namespace

Verdict WeightsFollowTheirVertices(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
