// The barycentric-space distance to an edge is lambda_i.
//
// So a width W draws a line that is W times the triangle's height wide, not W pixels.
#include <cstddef>
#include <optional>

#include "props/judging/wireframe_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentric_distance_is_the_smallest_coordinate {

std::optional<WireframeScale> InBarycentricSpace(const BarycentricQuery& q, int edge) {
  const exact::Rational lambda = ExactBarycentrics(q)[static_cast<std::size_t>(edge)];
  return WireframeScale{lambda * lambda, 1};
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskDistances(c, subject, WireframeForm::kBarycentric, InBarycentricSpace,
                      "barycentric-space distance is not the barycentric");
}

}  // namespace barycentric_distance_is_the_smallest_coordinate

extern const Property kBarycentricDistanceIsTheSmallestCoordinate;
constinit const Property kBarycentricDistanceIsTheSmallestCoordinate{
    .name = "BarycentricDistanceIsTheSmallestCoordinate",
    .group = "wireframe",
    .clause = "The barycentric-space test lambda_i <= W draws lines of W heights, not of W pixels.",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = {.shows = Shows::kBarycentrics,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = kInTheTriangle},
    .ask = barycentric_distance_is_the_smallest_coordinate::Ask,
};

}  // namespace rasterproof::props
