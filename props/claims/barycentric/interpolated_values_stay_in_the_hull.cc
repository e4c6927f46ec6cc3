// Inside the closed triangle a value interpolated with positive w lies between the least and the greatest vertex value, up to the bound claimed.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

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
    if (!q.at.inside) continue;
    const Point2 p = q.at.place.at;
    const auto [least, greatest] = std::ranges::minmax(q.attribute);
    for (const InterpolationForm form : {InterpolationForm::kWeights, InterpolationForm::kDeltas,
                                         InterpolationForm::kPerspective}) {
      const double bound = evaluator.InterpolationErrorBound(form, q.corners, q.attribute, p);
      if (!Claims(bound)) continue;
      ++exercised;
      const double value = evaluator.Interpolate(form, q.corners, q.attribute, p);
      // Inside the hull, or past the nearer end by at most the bound. NaN is neither.
      if (value >= least && value <= greatest) continue;
      const double end = value < least ? least : greatest;
      if (AgreeWithin(value, end, -1, bound, 0)) continue;
      return WeightViolation(
          q.at, -1, exercised,
          "value interpolated " + std::string(InterpolationName(form)) + " leaves the hull",
          HexText(value),
          "[" + HexText(least) + ", " + HexText(greatest) + "] within " + HexText(bound));
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kInterpolatedValuesStayInTheHull{
    .name = "InterpolatedValuesStayInTheHull",
    .group = "barycentric",
    .clause = "Inside, an interpolated value is a convex combination of the vertices' values.",
    .precondition =
        "the subject shows weights and claims a finite bound there; window space within the "
        "limits, area not zero; sample in the closed triangle; every w positive",
    .tolerance = kInterpolationBound,
    .domains = kWeights,
    .check = Judge,
};

}  // namespace rasterproof::props
