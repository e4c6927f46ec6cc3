#include "props/catalog/weight_sign.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/catalog/exact_comparison.h"
#include "props/catalog/weight_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict WeightSignsAgreeWithTheEdges(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  for (const auto& [q, form, weights, bounds] : WeightsAtQueries(*subject.Weights(), c)) {
    const Point2 p = q.place.at;
    const int facing = exact::Facing(q.v);
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (!Claims(bounds[k])) continue;
      // lambda_i = E_i / area: its sign is the product of theirs.
      const int sign = exact::EdgeSign(EdgeStart(q.v, i), EdgeEnd(q.v, i), p) * facing;
      if (HasSign(weights[k], sign)) {
        ++exercised;
        continue;
      }
      const exact::Rational lambda = ExactWeights(q)[k];
      if (bounds[k] > 0 && lambda.Abs() <= exact::Rational(bounds[k])) continue;
      ++exercised;
      return WeightViolation(
          q, i, exercised,
          "weight (" + std::string(FormName(form)) + ") of the wrong sign outside its band",
          HexText(weights[k]), lambda.ToString() + ", band " + HexText(bounds[k]));
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
