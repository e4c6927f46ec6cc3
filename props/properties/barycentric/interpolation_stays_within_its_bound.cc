// Interpolation by barycentrics and by deltas stays within the bound stated of the exact value.
#include <vector>

#include "props/judging/interpolation_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace interpolation_stays_within_its_bound {

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<InterpolationQuery> affine = SomeInterpolations(c);
  // w plays no part in the affine forms: the queries that differ in it alone are left out.
  std::erase_if(affine, [](const InterpolationQuery& q) {
    return q.corners[0].w != 1 || q.corners[2].w != 1;
  });
  return AskInterpolations(affine, {InterpolationForm::kBarycentrics, InterpolationForm::kDeltas},
                           *subject.barycentrics, InterpolationsStayWithinTheirBound);
}

}  // namespace interpolation_stays_within_its_bound

extern const Property kInterpolationStaysWithinItsBound;
constinit const Property kInterpolationStaysWithinItsBound{
    .name = "InterpolationStaysWithinItsBound",
    .group = "barycentric",
    .clause =
        "z = a z_a + b z_b + c z_c for depth and other affine quantities (OpenGL 4.6 "
        "section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .tolerance = kInterpolationBound,
    .domains = kBarycentrics,
    .gate = {.shows = Shows::kBarycentrics,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = interpolation_stays_within_its_bound::Ask,
};

}  // namespace rasterproof::props
