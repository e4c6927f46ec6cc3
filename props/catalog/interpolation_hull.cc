#include "props/catalog/interpolation_hull.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/interpolation_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict InterpolatedValuesStayInTheHull(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
