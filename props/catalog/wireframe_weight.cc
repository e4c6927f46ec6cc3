#include "props/catalog/wireframe_weight.h"

#include <cstddef>
#include <optional>

#include "props/catalog/wireframe_queries.h"

namespace rasterproof::props {
namespace {

std::optional<WireframeScale> InWeightSpace(const WeightQuery& q, int edge) {
  const exact::Rational lambda = ExactWeights(q)[static_cast<std::size_t>(edge)];
  return WireframeScale{lambda * lambda, 1};
}

}  // namespace

Verdict WeightDistanceIsTheSmallestWeight(Subject& subject, const Case& c) {
  return DistancesMean(subject, c, WireframeForm::kWeight, InWeightSpace,
                       "weight-space distance is not the weight");
}

}  // namespace rasterproof::props
