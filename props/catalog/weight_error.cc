#include "props/catalog/weight_error.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/weight_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict WeightsStayWithinTheirBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  const WeightEvaluator& evaluator = *subject.Weights();
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const WeightQuery& q : SomeWeightQueries(c)) {
    const std::array<exact::Rational, 3> lambda = ExactWeights(q);
    for (const BarycentricForm form : FormsFor(q)) {
      const std::array<double, 3> weights = evaluator.Weights(form, q.v, q.place.at);
      const std::array<double, 3> bounds = evaluator.WeightErrorBounds(form, q.v, q.place.at);
      for (std::size_t i = 0; i < 3; ++i) {
        if (!Claims(bounds[i])) continue;
        ++exercised;
        const Distance distance = CompareWithExact(weights[i], lambda[i], bounds[i]);
        if (!distance.within) {
          return WeightViolation(
              q, static_cast<int>(i), exercised,
              "weight (" + std::string(FormName(form)) + ") outside its proven bound",
              HexText(weights[i]), lambda[i].ToString() + " within " + HexText(bounds[i]));
        }
        worst = std::max(worst, distance.ratio);
      }
    }
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
