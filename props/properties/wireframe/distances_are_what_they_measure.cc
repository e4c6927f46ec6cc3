// Each form of the distance to an edge measures what it is said to: a share of the height, pixels
// in the L1 norm of the gradient, or pixels.
#include <cstddef>
#include <optional>

#include "exact/attributes.h"
#include "exact/edge.h"
#include "props/judging/wireframe_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

std::optional<WireframeScale> InBarycentricSpace(const BarycentricQuery& q, int edge) {
  const exact::Rational lambda = ExactBarycentrics(q)[static_cast<std::size_t>(edge)];
  return WireframeScale{lambda * lambda, 1};
}

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

std::optional<WireframeScale> InPixels(const BarycentricQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  const auto distance = exact::SquaredLineDistance(a, b, q.place.at);
  const auto height = exact::SquaredLineDistance(a, b, q.v[static_cast<std::size_t>(edge)]);
  if (!distance || !height) return std::nullopt;
  return WireframeScale{*distance, RoundedRoot(*height)};
}

}  // namespace

// The barycentric-space distance to an edge is lambda_i.
//
// So a width W draws a line that is W times the triangle's height wide, not W pixels.
extern constinit const Property kBarycentricDistanceIsTheSmallestCoordinate{
    .name = "BarycentricDistanceIsTheSmallestCoordinate",
    .group = "wireframe",
    .clause = "The barycentric-space test lambda_i <= W draws lines of W heights, not of W pixels.",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kInTheTriangle),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return AskDistances(c, subject, WireframeForm::kBarycentric, InBarycentricSpace,
                              "barycentric-space distance is not the barycentric");
        },
};

// Dividing by |d lambda/dx| + |d lambda/dy| measures pixels in the L1 norm of the gradient.
//
// That is between 1/sqrt(2) of the distance (diagonal edges) and the distance (along an axis).
extern constinit const Property kDerivativeDistanceMeasuresInTheL1Norm{
    .name = "DerivativeDistanceMeasuresInTheL1Norm",
    .group = "wireframe",
    .clause =
        "lambda_i / fwidth(lambda_i) with fwidth = |d/dx| + |d/dy| (GLSL 4.60 section "
        "8.14.1) is |E_i| / (|dX| + |dY|).",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kInTheTriangle),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return AskDistances(c, subject, WireframeForm::kDerivative, InTheL1Norm,
                              "derivative-weighted distance is not that of the L1 norm");
        },
};

// lambda_i times the height over edge i is the distance to that edge in pixels.
extern constinit const Property kHeightDistanceIsTheDistanceInPixels{
    .name = "HeightDistanceIsTheDistanceInPixels",
    .group = "wireframe",
    .clause = "lambda_i times the height over edge i is the distance to edge i.",
    .tolerance = kWireframeBound,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kInTheTriangle),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return AskDistances(c, subject, WireframeForm::kHeight, InPixels,
                              "height-compensated distance is not the distance in pixels");
        },
};

}  // namespace rasterproof::props
