// A weight has the sign of its exact lambda wherever |lambda| exceeds the bound claimed.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/coverage.h"
#include "exact/edge.h"
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
  for (const auto& [q, forms] : answers) {
    const int facing = exact::Facing(q.v);
    for (const auto& [form, weights, bounds] : forms) {
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!Claims(bounds[k])) continue;
        // lambda_i = E_i / area: its sign is the product of theirs.
        const int sign = exact::EdgeSign(EdgeStart(q.v, i), EdgeEnd(q.v, i), q.place.at) * facing;
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
  }
  return Verdict::Held(exercised);
}

Asked Ask(const Case& c, const Description& subject) {
  return AskWeights(SomeWeightQueries(c), *subject.weights, Judge);
}

}  // namespace

constinit const Property kWeightSignsAgreeWithTheEdges{
    .name = "WeightSignsAgreeWithTheEdges",
    .group = "barycentric",
    .clause =
        "a, b, c lie in [0, 1] inside the triangle (OpenGL 4.6 section 14.6.1 and Vulkan "
        "1.3, Basic Polygon Rasterization), and one of them is negative outside.",
    .tolerance = "the subject's proven WeightErrorBounds; where they are 0, none: exact",
    .domains = kWeights,
    .gate = {.shows = Shows::kBarycentrics,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = Ask,
};

}  // namespace rasterproof::props
