#include "props/catalog/wireframe_derivative.h"

#include <optional>

#include "exact/edge.h"
#include "props/catalog/wireframe_queries.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

// lambda_i = E_i / area with gradient (dY, -dX) / area: over the L1 norm of the gradient that is
// |E_i| / (|dX| + |dY|).
std::optional<WireframeScale> InTheL1Norm(const WeightQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  const Rational reach =
      (Rational(b.x) - Rational(a.x)).Abs() + (Rational(b.y) - Rational(a.y)).Abs();
  if (reach.Sign() == 0) return std::nullopt;
  const Rational area = exact::EdgeValue(q.v[0], q.v[1], q.v[2]).Abs();
  const Rational distance = exact::EdgeValue(a, b, q.place.at) / reach;
  return WireframeScale{distance * distance, (area / reach).ToDouble()};
}

}  // namespace

Verdict DerivativeDistanceMeasuresInTheL1Norm(Subject& subject, const Case& c) {
  return DistancesMean(subject, c, WireframeForm::kDerivative, InTheL1Norm,
                       "derivative-weighted distance is not that of the L1 norm");
}

}  // namespace rasterproof::props
