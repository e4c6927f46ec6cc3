// The three weights, added exactly, sum to one within the bound claimed for the form.
#include <algorithm>
#include <array>
#include <cmath>
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

using exact::Rational;

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  const WeightEvaluator& evaluator = *subject.Weights();
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const WeightQuery& q : SomeWeightQueries(c)) {
    for (const BarycentricForm form : FormsFor(q)) {
      const double bound = evaluator.SumErrorBound(form, q.v, q.place.at);
      if (!Claims(bound)) continue;
      ++exercised;
      const std::array<double, 3> l = evaluator.Weights(form, q.v, q.place.at);
      const std::string claim = "weights (" + std::string(FormName(form)) + ") do not sum to one";
      const std::string observed = HexText(l[0]) + ", " + HexText(l[1]) + ", " + HexText(l[2]);
      if (!std::ranges::all_of(l, [](double x) { return std::isfinite(x); })) {
        return WeightViolation(q, -1, exercised, claim, observed, "finite weights");
      }
      const Rational rest = Rational(1) - Rational(l[0]) - Rational(l[1]);
      const Distance distance = CompareWithExact(l[2], rest, bound);
      if (!distance.within) {
        return WeightViolation(q, -1, exercised, claim, observed,
                               "a sum of 1 within " + HexText(bound));
      }
      worst = std::max(worst, distance.ratio);
    }
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace

constinit const Property kWeightsSumToOne{
    .name = "WeightsSumToOne",
    .group = "barycentric",
    .clause =
        "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .precondition = kWeightValues,
    .tolerance = "the subject's proven SumErrorBound",
    .domains = kWeights,
    .check = Judge,
};

}  // namespace rasterproof::props
