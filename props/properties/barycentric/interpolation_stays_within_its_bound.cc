// Interpolation stays within the bound stated of the exact value: by barycentrics, by deltas, and
// perspective-correct.
#include <vector>

#include "props/judging/values/interpolation_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {

// Interpolation by barycentrics and by deltas stays within the bound stated of the exact value.
extern constinit const Property kInterpolationStaysWithinItsBound{
    .name = "InterpolationStaysWithinItsBound",
    .group = "barycentric",
    .clause =
        "z = a z_a + b z_b + c z_c for depth and other affine quantities (OpenGL 4.6 "
        "section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .tolerance = kInterpolationBound,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          std::vector<InterpolationQuery> affine = SomeInterpolations(c);
          // w plays no part in the affine forms: the queries that differ in it alone are left out.
          std::erase_if(affine, [](const InterpolationQuery& q) {
            return q.corners[0].w != 1 || q.corners[2].w != 1;
          });
          return AskInterpolations(affine,
                                   {InterpolationForm::kBarycentrics, InterpolationForm::kDeltas},
                                   *subject.barycentrics, InterpolationsStayWithinTheirBound);
        },
};

// Perspective-correct interpolation stays within the bound stated of the exact quotient.
extern constinit const Property kPerspectiveInterpolationStaysWithinItsBound{
    .name = "PerspectiveInterpolationStaysWithinItsBound",
    .group = "barycentric",
    .clause =
        "f = (sum a f_a / w_a) / (sum a / w_a) (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, "
        "Basic Polygon Rasterization; Heckbert and Moreton 1991).",
    .tolerance = kInterpolationBound,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, "area not zero; every w positive"),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return AskInterpolations(SomeInterpolations(c), {InterpolationForm::kPerspective},
                                   *subject.barycentrics, InterpolationsStayWithinTheirBound);
        },
};

}  // namespace rasterproof::props
