// z0 + l1 (z1 - z0) + l2 (z2 - z0) and l0 z0 + l1 z1 + l2 z2 agree up to the sum of their bounds.
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/interpolation_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace depth_by_deltas_equals_depth_by_barycentrics {

// A query with the bounds that the subject states on both values.
struct BoundedPair {
  InterpolationQuery query;
  double barycentrics_bound = 0;
  double deltas_bound = 0;
};

Verdict Judge(const std::vector<BoundedPair>& pairs, const Answers& answers) {
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [q, barycentrics_bound, deltas_bound] = pairs[k];
    const double by_barycentrics = answers.interpolations[2 * k];
    const double by_deltas = answers.interpolations[2 * k + 1];
    ++exercised;
    if (AgreeWithin(by_deltas, by_barycentrics, -1, deltas_bound, barycentrics_bound)) continue;
    return BarycentricViolation(
        q.at, -1, exercised, "depth by deltas differs from depth by barycentrics",
        {by_deltas, " by deltas"},
        {by_barycentrics, " by barycentrics, within ", deltas_bound + barycentrics_bound});
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<BoundedPair> pairs;
  Questions questions;
  for (const InterpolationQuery& q : SomeInterpolations(c)) {
    const Point2 p = q.at.place.at;
    const auto bound = [&](InterpolationForm form) {
      return subject.barycentrics->InterpolationErrorBound(form, q.corners, q.attribute, p);
    };
    const double barycentrics_bound = bound(InterpolationForm::kBarycentrics);
    const double deltas_bound = bound(InterpolationForm::kDeltas);
    if (!IsStated(barycentrics_bound) || !IsStated(deltas_bound)) continue;
    pairs.push_back({q, barycentrics_bound, deltas_bound});
    for (const InterpolationForm form :
         {InterpolationForm::kBarycentrics, InterpolationForm::kDeltas}) {
      questions.interpolations.push_back({form, q.corners, q.attribute, p});
    }
  }
  return OneCheck(std::move(questions), [pairs = std::move(pairs)](const Answers& answers) {
    return Judge(pairs, answers);
  });
}

}  // namespace depth_by_deltas_equals_depth_by_barycentrics

extern constinit const Property kDepthByDeltasEqualsDepthByBarycentrics{
    .name = "DepthByDeltasEqualsDepthByBarycentrics",
    .group = "barycentric",
    .clause =
        "z0 + l1 (z1 - z0) + l2 (z2 - z0) is l0 z0 + l1 z1 + l2 z2 because the barycentrics sum "
        "to one.",
    .tolerance = "the sum of both proven InterpolationErrorBounds",
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask = depth_by_deltas_equals_depth_by_barycentrics::Ask,
};

}  // namespace rasterproof::props
