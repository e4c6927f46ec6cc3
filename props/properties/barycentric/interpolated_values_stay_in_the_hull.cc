// In the closed triangle a value interpolated with positive w lies between its vertices' values.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/interpolation_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace interpolated_values_stay_in_the_hull {

Verdict Judge(const std::vector<InterpolationAnswer>& answers) {
  std::uint64_t exercised = 0;
  for (const auto& [q, form, bound, value] : answers) {
    const auto [least, greatest] = std::ranges::minmax(q.attribute);
    ++exercised;
    // Inside the hull, or past the nearer end by at most the bound. NaN is neither.
    if (value >= least && value <= greatest) continue;
    const double end = value < least ? least : greatest;
    if (AgreeWithin(value, end, -1, bound, 0)) continue;
    return BarycentricViolation(
        q.at, -1, exercised,
        "value interpolated " + std::string(InterpolationName(form)) + " leaves the hull", {value},
        {"[", least, ", ", greatest, "] within ", bound});
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<InterpolationQuery> inside = SomeInterpolations(c);
  std::erase_if(inside, [](const InterpolationQuery& q) { return !q.at.inside; });
  return AskInterpolations(inside,
                           {InterpolationForm::kBarycentrics, InterpolationForm::kDeltas,
                            InterpolationForm::kPerspective},
                           *subject.barycentrics, Judge);
}

}  // namespace interpolated_values_stay_in_the_hull

extern constinit const Property kInterpolatedValuesStayInTheHull{
    .name = "InterpolatedValuesStayInTheHull",
    .group = "barycentric",
    .clause = "Inside, an interpolated value is a convex combination of the vertices' values.",
    .tolerance = kInterpolationBound,
    .domains = kBarycentrics,
    .gate =
        Where(kAsksBarycentrics, "area not zero; samples in the closed triangle; every w positive"),
    .ask = interpolated_values_stay_in_the_hull::Ask,
};

}  // namespace rasterproof::props
