// Every weight lies within the subject's bound of lambda_i; unsigned ones only in the triangle.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/weight_queries.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(const std::vector<WeightAnswer>& answers) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const auto& [q, forms] : answers) {
    const std::array<exact::Rational, 3> lambda = ExactWeights(q);
    for (const auto& [form, weights, bounds] : forms) {
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

Asked Ask(const Case& c, const Description& subject) {
  return AskWeights(SomeWeightQueries(c), *subject.weights, Judge);
}

}  // namespace

constinit const Property kWeightsStayWithinTheirBound{
    .name = "WeightsStayWithinTheirBound",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1, the weights a, b, c).",
    .tolerance = kWeightBounds,
    .domains = kWeights,
    .gate = {.shows = Shows::kBarycentrics,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = "area not zero; unsigned areas: closed triangle only"},
    .ask = Ask,
};

}  // namespace rasterproof::props
