// Perspective-correct interpolation stays within the bound stated of the exact quotient.
#include "props/judging/interpolation_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace perspective_interpolation_stays_within_its_bound {

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskInterpolations(SomeInterpolations(c), {InterpolationForm::kPerspective},
                           *subject.barycentrics, InterpolationsStayWithinTheirBound);
}

}  // namespace perspective_interpolation_stays_within_its_bound

extern const Property kPerspectiveInterpolationStaysWithinItsBound;
constinit const Property kPerspectiveInterpolationStaysWithinItsBound{
    .name = "PerspectiveInterpolationStaysWithinItsBound",
    .group = "barycentric",
    .clause =
        "f = (sum a f_a / w_a) / (sum a / w_a) (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, "
        "Basic Polygon Rasterization; Heckbert and Moreton 1991).",
    .tolerance = kInterpolationBound,
    .domains = kBarycentrics,
    .gate = {.shows = Shows::kBarycentrics,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = "area not zero; every w positive"},
    .ask = perspective_interpolation_stays_within_its_bound::Ask,
};

}  // namespace rasterproof::props
