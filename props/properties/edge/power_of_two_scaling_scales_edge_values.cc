// Enlarging edge and sample by 2^k multiplies E by 4^k, where the results are on the input lattice.
#include <array>

#include "props/judging/edge_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace power_of_two_scaling_scales_edge_values {

// Upwards only: the way down is the same property read backwards, and could meet subnormals.
constexpr std::array<EdgeMap, 3> kScalings{{
    {.sx = 2, .sy = 2, .factor = 4},
    {.sx = 32, .sy = 32, .factor = 0x1p10},
    {.sx = 0x1p20, .sy = 0x1p20, .factor = 0x1p40},
}};

Checks Ask(const PlacedCase& c, const Description& subject) {
  return EdgeValuesFollow(c, subject, kScalings, "edge value does not scale by 4^k");
}

}  // namespace power_of_two_scaling_scales_edge_values

extern const Property kPowerOfTwoScalingScalesEdgeValues;
constinit const Property kPowerOfTwoScalingScalesEdgeValues{
    .name = "PowerOfTwoScalingScalesEdgeValues",
    .group = "edge",
    .clause = "E is homogeneous of degree two in the positions.",
    .tolerance = "the sum of both proven ErrorBounds, scaled",
    .domains = kOnTheLattice,
    .gate = Where(kAsksEdgeValues,
                  "the scaled coordinates are exact, of the input format, on the subpixel grid and "
                  "within the limit"),
    .ask = power_of_two_scaling_scales_edge_values::Ask,
};

}  // namespace rasterproof::props
