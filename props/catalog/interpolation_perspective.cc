#include "props/catalog/interpolation_perspective.h"

#include <optional>

#include "props/catalog/interpolation_queries.h"

namespace rasterproof::props {

Verdict PerspectiveInterpolationStaysWithinItsBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  return InterpolationsStayWithinTheirBound(*subject.Weights(), SomeInterpolations(c),
                                            {InterpolationForm::kPerspective});
}

}  // namespace rasterproof::props
