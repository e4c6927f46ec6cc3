#include "props/catalog/outputs.h"

#include <array>

#include "props/catalog/batch.h"
#include "props/catalog/domain_lists.h"
#include "props/catalog/fragment_depth.h"
#include "props/catalog/fragment_hull.h"
#include "props/catalog/fragment_sum.h"
#include "props/catalog/fragment_weights.h"
#include "props/catalog/one_call.h"
#include "props/catalog/repeated_draw.h"
#include "props/catalog/row_words.h"
#include "props/catalog/winner.h"

namespace rasterproof::props {
namespace {

constexpr auto kProperties = std::to_array<Property>({
    {.name = "EqualDrawsGiveEqualCounts",
     .group = "extremes",
     .clause = "Equal calls give equal counts, and counts are added to.",
     .precondition = "any contract but none; coordinates within the limit",
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = EqualDrawsGiveEqualCounts,
     .is_about_sequence = true},
    {.name = "FragmentWeightsSumToOne",
     .group = "barycentric",
     .clause =
         "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
     .precondition = kFragmentValues,
     .tolerance = "the sum of the three tolerances of FragmentWeightsStayWithinTheirError",
     .domains = kWeights,
     .check = FragmentWeightsSumToOne},
    {.name = "FragmentWeightsStayWithinTheirError",
     .group = "barycentric",
     .clause = "lambda_i is the signed area of the part opposite vertex i over that of the whole "
               "(OpenGL 4.6 section 14.6.1), by the vertices that the subject names.",
     .precondition = kFragmentValues,
     .tolerance = "the declared weight error; none declared: the forward bound of the "
                  "five-operation quotient, which grows with the triangle's conditioning",
     .domains = kWeights,
     .check = FragmentWeightsStayWithinTheirError},
    {.name = "FragmentDepthStaysInTheHull",
     .group = "barycentric",
     .clause = "Inside, a depth is a convex combination of the vertices' depths.",
     .precondition = "the subject shows fragments; window space within the limits; samples in the "
                     "closed triangle of the vertices that it names",
     .tolerance = kDepthTolerance,
     .domains = kWeights,
     .check = FragmentDepthStaysInTheHull},
    {.name = "FragmentDepthFollowsItsWeights",
     .group = "barycentric",
     .clause = "z = a z_a + b z_b + c z_c (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon "
               "Rasterization).",
     .precondition = kFragmentValues,
     .tolerance = "the depth's and the weights' tolerances, the latter times the vertices' depths",
     .domains = kWeights,
     .check = FragmentDepthFollowsItsWeights},
    {.name = "OneCallDrawsLikeItsTriangles",
     .group = "coverage",
     .clause = "A mesh is its triangles: what one call with all of them gives, also behind 256 "
               "others, is what calls with each alone add up to.",
     .precondition = "contract sample-exact; coordinates within the limit; two triangles or more",
     .tolerance = kExact,
     .domains = kMeshes,
     .check = OneCallDrawsLikeItsTriangles},
    {.name = "WinnerFollowsTheDeclaredOrder",
     .group = "coverage",
     .clause = "Primitives are drawn in order (OpenGL 4.6 section 2.1; Vulkan 1.3, Rasterization "
               "Order): without a depth test the last one on a sample stays.",
     .precondition = "the subject shows winners; contract sample-exact; coordinates within the "
                     "limit",
     .tolerance = kExact,
     .domains = kAnyMesh,
     .check = WinnerFollowsTheDeclaredOrder},
    {.name = "BatchDrawsLikeSingleCalls",
     .group = "extremes",
     .clause = "Scenes that share a call have nothing to do with each other.",
     .precondition = "the subject takes batches; any contract but none; coordinates within the "
                     "limit",
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = BatchDrawsLikeSingleCalls,
     .is_about_sequence = true},
});

}  // namespace

std::span<const Property> OutputProperties() { return kProperties; }

}  // namespace rasterproof::props
