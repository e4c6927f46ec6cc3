// Each form of the distance to an edge measures what it is said to: a share of the height, pixels
// in the L1 norm of the gradient, or pixels.
#include <array>
#include <type_traits>

#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "props/judging/values/estimate.h"
#include "props/judging/values/wireframe_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

// The formulas below are of N: Rational or Estimate. The queries have no triangle of zero area, so
// no edge without a length.
template <class N>
N EdgeIn(Point2 a, Point2 b, Point2 p) {
  if constexpr (std::is_same_v<N, Rational>) {
    return exact::EdgeValue(a, b, p);
  } else {
    return EstimatedEdge(a, b, p);
  }
}

template <class N>
N Square(const N& x) {
  return x * x;
}

template <class N>
N Area(const BarycentricQuery& q) {
  return EdgeIn<N>(q.v[0], q.v[1], q.v[2]);
}

template <class N>
N EdgeNear(const BarycentricQuery& q, int edge) {
  return EdgeIn<N>(EdgeStart(q.v, edge), EdgeEnd(q.v, edge), q.place.at);
}

// (dX, dY) of an edge.
template <class N>
std::array<N, 2> Side(const BarycentricQuery& q, int edge) {
  const Point2 a = EdgeStart(q.v, edge);
  const Point2 b = EdgeEnd(q.v, edge);
  return {N(b.x) - N(a.x), N(b.y) - N(a.y)};
}

template <class N>
WireframeScale<N> InBarycentricSpace(const BarycentricQuery& q, int edge) {
  return {Square<N>(EdgeNear<N>(q, edge) / Area<N>(q)), 1};
}

// lambda_i = E_i / area with gradient (dY, -dX) / area: over the L1 norm of the gradient that is
// |E_i| / (|dX| + |dY|).
template <class N>
WireframeScale<N> InTheL1Norm(const BarycentricQuery& q, int edge) {
  const auto [dx, dy] = Side<N>(q, edge);
  const N reach = dx.Abs() + dy.Abs();
  return {Square<N>(EdgeNear<N>(q, edge) / reach), Nearest(Area<N>(q).Abs() / reach)};
}

// The distance is |E_i| over the edge's length, the height |area| over it.
template <class N>
WireframeScale<N> InPixels(const BarycentricQuery& q, int edge) {
  const auto [dx, dy] = Side<N>(q, edge);
  const N length = Square(dx) + Square(dy);
  return {Square<N>(EdgeNear<N>(q, edge)) / length, RoundedRoot(Square<N>(Area<N>(q)) / length)};
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
          return AskDistances(c, subject, WireframeForm::kBarycentric,
                              {InBarycentricSpace<Rational>, InBarycentricSpace<Estimate>},
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
          return AskDistances(c, subject, WireframeForm::kDerivative,
                              {InTheL1Norm<Rational>, InTheL1Norm<Estimate>},
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
          return AskDistances(c, subject, WireframeForm::kHeight,
                              {InPixels<Rational>, InPixels<Estimate>},
                              "height-compensated distance is not the distance in pixels");
        },
};

}  // namespace rasterproof::props
