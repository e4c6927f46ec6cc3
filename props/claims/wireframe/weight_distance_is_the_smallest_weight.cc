// The weight-space distance to an edge is lambda_i.
//
// So a width W draws a line that is W times the triangle's height wide, not W pixels.
#include <cstddef>
#include <optional>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/wireframe_queries.h"

namespace rasterproof::props {
namespace {

std::optional<WireframeScale> InWeightSpace(const WeightQuery& q, int edge) {
  const exact::Rational lambda = ExactWeights(q)[static_cast<std::size_t>(edge)];
  return WireframeScale{lambda * lambda, 1};
}

Asked Ask(const Case& c, const Description& subject) {
  return AskDistances(c, subject, WireframeForm::kWeight, InWeightSpace,
                      "weight-space distance is not the weight");
}

}  // namespace

constinit const Property kWeightDistanceIsTheSmallestWeight{
    .name = "WeightDistanceIsTheSmallestWeight",
    .group = "wireframe",
    .clause = "The weight-space test lambda_i <= W draws lines of W heights, not of W pixels.",
    .tolerance = kWireframeBound,
    .domains = kWeights,
    .gate = {.shows = Shows::kBarycentrics,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = kInTheTriangle},
    .ask = Ask,
};

}  // namespace rasterproof::props
