// lambda_i times the height over edge i is the distance to that edge in pixels.
#include <cstddef>
#include <optional>

#include "exact/attributes.h"
#include "props/judging/wireframe_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace height_distance_is_the_distance_in_pixels {

std::optional<WireframeScale> InPixels(const BarycentricQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  const auto distance = exact::SquaredLineDistance(a, b, q.place.at);
  const auto height = exact::SquaredLineDistance(a, b, q.v[static_cast<std::size_t>(edge)]);
  if (!distance || !height) return std::nullopt;
  return WireframeScale{*distance, RoundedRoot(*height)};
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskDistances(c, subject, WireframeForm::kHeight, InPixels,
                      "height-compensated distance is not the distance in pixels");
}

}  // namespace height_distance_is_the_distance_in_pixels

extern const Property kHeightDistanceIsTheDistanceInPixels;
constinit const Property kHeightDistanceIsTheDistanceInPixels{
    .name = "HeightDistanceIsTheDistanceInPixels",
    .group = "wireframe",
    .clause = "lambda_i times the height over edge i is the distance to edge i.",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = {.shows = Shows::kBarycentrics,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = kInTheTriangle},
    .ask = height_distance_is_the_distance_in_pixels::Ask,
};

}  // namespace rasterproof::props
