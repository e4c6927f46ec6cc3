#include "props/catalog/wireframe_height.h"

#include <cstddef>
#include <optional>

#include "exact/attributes.h"
#include "props/catalog/wireframe_queries.h"

namespace rasterproof::props {
namespace {

std::optional<WireframeScale> InPixels(const WeightQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  const auto distance = exact::SquaredLineDistance(a, b, q.place.at);
  const auto height = exact::SquaredLineDistance(a, b, q.v[static_cast<std::size_t>(edge)]);
  if (!distance || !height) return std::nullopt;
  return WireframeScale{*distance, RoundedRoot(*height)};
}

}  // namespace

Verdict HeightDistanceIsTheDistanceInPixels(Subject& subject, const Case& c) {
  return DistancesMean(subject, c, WireframeForm::kHeight, InPixels,
                       "height-compensated distance is not the distance in pixels");
}

}  // namespace rasterproof::props
