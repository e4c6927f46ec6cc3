// Perspective-correct interpolation stays within the bound claimed of the exact quotient.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/interpolation_queries.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& subject) {
  return AskInterpolations(SomeInterpolations(c), {InterpolationForm::kPerspective},
                           *subject.weights, InterpolationsStayWithinTheirBound);
}

}  // namespace

constinit const Property kPerspectiveInterpolationStaysWithinItsBound{
    .name = "PerspectiveInterpolationStaysWithinItsBound",
    .group = "barycentric",
    .clause =
        "f = (sum a f_a / w_a) / (sum a / w_a) (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, "
        "Basic Polygon Rasterization; Heckbert and Moreton 1991).",
    .tolerance = kInterpolationBound,
    .domains = kWeights,
    .gate = {.shows = Shows::kBarycentrics,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = "area not zero; every w positive"},
    .ask = Ask,
};

}  // namespace rasterproof::props
