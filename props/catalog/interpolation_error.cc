#include "props/catalog/interpolation_error.h"

#include <optional>
#include <vector>

#include "props/catalog/interpolation_queries.h"

namespace rasterproof::props {

Verdict InterpolationStaysWithinItsBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  std::vector<InterpolationQuery> affine = SomeInterpolations(c);
  // w plays no part in the affine forms: the queries that differ in it alone are left out.
  std::erase_if(affine, [](const InterpolationQuery& q) {
    return q.corners[0].w != 1 || q.corners[2].w != 1;
  });
  return InterpolationsStayWithinTheirBound(
      *subject.Weights(), affine, {InterpolationForm::kWeights, InterpolationForm::kDeltas});
}

}  // namespace rasterproof::props
