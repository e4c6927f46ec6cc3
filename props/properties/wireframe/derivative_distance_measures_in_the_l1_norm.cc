// Dividing by |d lambda/dx| + |d lambda/dy| measures pixels in the L1 norm of the gradient.
//
// That is between 1/sqrt(2) of the distance (diagonal edges) and the distance (along an axis).
#include <optional>

#include "exact/edge.h"
#include "props/judging/wireframe_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace derivative_distance_measures_in_the_l1_norm {

using exact::Rational;

// lambda_i = E_i / area with gradient (dY, -dX) / area: over the L1 norm of the gradient that is
// |E_i| / (|dX| + |dY|).
std::optional<WireframeScale> InTheL1Norm(const BarycentricQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  const Rational reach =
      (Rational(b.x) - Rational(a.x)).Abs() + (Rational(b.y) - Rational(a.y)).Abs();
  if (reach.Sign() == 0) return std::nullopt;
  const Rational area = exact::EdgeValue(q.v[0], q.v[1], q.v[2]).Abs();
  const Rational distance = exact::EdgeValue(a, b, q.place.at) / reach;
  return WireframeScale{distance * distance, (area / reach).ToDouble()};
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskDistances(c, subject, WireframeForm::kDerivative, InTheL1Norm,
                      "derivative-weighted distance is not that of the L1 norm");
}

}  // namespace derivative_distance_measures_in_the_l1_norm

extern const Property kDerivativeDistanceMeasuresInTheL1Norm;
constinit const Property kDerivativeDistanceMeasuresInTheL1Norm{
    .name = "DerivativeDistanceMeasuresInTheL1Norm",
    .group = "wireframe",
    .clause =
        "lambda_i / fwidth(lambda_i) with fwidth = |d/dx| + |d/dy| (GLSL 4.60 section "
        "8.14.1) is |E_i| / (|dX| + |dY|).",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = {.shows = Shows::kBarycentrics,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = kInTheTriangle},
    .ask = derivative_distance_measures_in_the_l1_norm::Ask,
};

}  // namespace rasterproof::props
