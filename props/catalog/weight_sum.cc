#include "props/catalog/weight_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/weight_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

}  // namespace

Verdict WeightsSumToOne(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
