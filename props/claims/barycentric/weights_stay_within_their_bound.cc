// Every weight lies within the subject's own proven bound of lambda_i, in every form; the unsigned form only inside the closed triangle, where alone it means lambda_i.
#include <algorithm>
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

Verdict Judge(Subject& subject, const Case& c) {
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

}  // namespace

constinit const Property kWeightsStayWithinTheirBound{
    .name = "WeightsStayWithinTheirBound",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1, the weights a, b, c).",
    .precondition =
        "the subject shows weights and claims a finite bound there; window space "
        "within the limits, area not zero; unsigned areas: closed triangle only",
    .tolerance = kWeightBounds,
    .domains = kWeights,
    .check = Judge,
};

}  // namespace rasterproof::props
