// Each triangle alone, and the mesh, covers no square that the profile does not allow it.
#include <array>

#include "exact/square_coverage.h"
#include "props/judging/squares.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace squares_outside_the_may_region_stay_free {

constexpr std::array kRules{kMayCoverSquares, kDrawsLargeTriangles};

CoverageCounts MostOf(const PlacedCase& c, const DrawOptions& options) {
  return exact::MayCover(c, options);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CompareEachAndAll(c, subject, MayBe::kLess,
                           "squares: one that may not be covered is covered", MostOf);
}

}  // namespace squares_outside_the_may_region_stay_free

extern constinit const Property kSquaresOutsideTheMayRegionStayFree{
    .name = "SquaresOutsideTheMayRegionStayFree",
    .group = "square",
    .clause =
        "No square outside the profile's may region is covered: \"only if they are within an "
        "uncertainty region\" (Direct3D conservative rasterization 3.2), \"only generated if the "
        "pixel area is fully covered\" (Vulkan, underestimation).",
    .required_by = kSquaresThatMayBeClauses,
    .tolerance = kExact,
    .domains = kSquareDomains,
    .gate = SquareGate(squares_outside_the_may_region_stay_free::kRules),
    .ask = squares_outside_the_may_region_stay_free::Ask,
};

}  // namespace rasterproof::props
