#include "props/judging/values/barycentric_queries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/scene.h"
#include "exact/attributes.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Exact barycentrics are rationals, some ten microseconds each: a few dozen for a case.
constexpr int kBarycentricTriangles = 2;
constexpr std::size_t kNearEdges = 5;
constexpr double kLargestAttribute = 0x1p20;

int PixelOf(double x, int size) {
  if (!(x > 0)) return 0;
  return x >= size ? size - 1 : static_cast<int>(x);
}

// The samples of the pixels at the centroid and half-way from it to each vertex: some are inside
// unless the triangle is thinner than a pixel.
void AddInner(const PlacedCase& c, const std::array<Point2, 3>& v,
              std::vector<SamplePlace>& places) {
  const Point2 centroid{v[0].x / 3 + v[1].x / 3 + v[2].x / 3, v[0].y / 3 + v[1].y / 3 + v[2].y / 3};
  const auto add = [&](Point2 p) {
    const int line = PixelOf(p.y, c.scene.height);
    const int row = c.profile.y_axis == YAxis::kDown ? line : c.scene.height - 1 - line;
    places.push_back(PlaceOf(c, PixelOf(p.x, c.scene.width), row, 0));
  };
  add(centroid);
  for (const Point2& vertex : v) {
    add({centroid.x / 2 + vertex.x / 2, centroid.y / 2 + vertex.y / 2});
  }
}

}  // namespace

bool InClosedTriangle(const std::array<Point2, 3>& v, Point2 p) {
  const int facing = exact::Facing(v);
  for (int i = 0; i < 3; ++i) {
    if (exact::EdgeSign(EdgeStart(v, i), EdgeEnd(v, i), p) * facing < 0) return false;
  }
  return true;
}

std::vector<CornersPlace> SomeProperTriangles(const PlacedCase& c) {
  constexpr int kLookedAt = 64;
  std::vector<CornersPlace> proper = SomeTriangles(c, kLookedAt);
  std::erase_if(proper, [](const CornersPlace& place) { return exact::Facing(place.at) == 0; });
  if (proper.size() > kBarycentricTriangles) proper.resize(kBarycentricTriangles);
  return proper;
}

std::vector<BarycentricQuery> SomeBarycentricQueries(const PlacedCase& c) {
  std::vector<BarycentricQuery> queries;
  for (const CornersPlace& corners : SomeProperTriangles(c)) {
    std::vector<SamplePlace> places;
    AddInner(c, corners.at, places);
    const std::vector<SamplePlace> near = SamplesNearEdges(c, corners.at, 2);
    const std::size_t stride = near.size() / kNearEdges + 1;
    for (std::size_t k = 0; k < near.size(); k += stride) places.push_back(near[k]);
    for (const SamplePlace& place : places) {
      queries.push_back(
          {corners.triangle, corners.at, place, InClosedTriangle(corners.at, place.at)});
    }
  }
  return queries;
}

std::vector<BarycentricForm> FormsFor(const BarycentricQuery& q) {
  std::vector<BarycentricForm> forms{BarycentricForm::kVertexArea, BarycentricForm::kSum,
                                     BarycentricForm::kOneMinus};
  if (q.inside) forms.push_back(BarycentricForm::kUnsignedArea);
  return forms;
}

Checks AskBarycentrics(const std::vector<BarycentricQuery>& queries,
                       const BarycentricBounds& bounds,
                       Verdict (*judge)(const std::vector<BarycentricAnswer>&)) {
  std::vector<BarycentricAnswer> unanswered;
  Questions questions;
  for (const BarycentricQuery& q : queries) {
    BarycentricAnswer& answer = unanswered.emplace_back(BarycentricAnswer{q, {}});
    for (const BarycentricForm form : FormsFor(q)) {
      answer.forms.push_back({form, {}, bounds.BarycentricErrorBounds(form, q.v, q.place.at)});
      questions.barycentrics.push_back({form, q.v, q.place.at});
    }
  }
  return OneCheck(std::move(questions),
                  [judge, unanswered = std::move(unanswered)](const Answers& answers) {
                    std::vector<BarycentricAnswer> answered = unanswered;
                    std::size_t next = 0;
                    for (BarycentricAnswer& answer : answered) {
                      for (FormAnswer& f : answer.forms)
                        f.barycentrics = answers.barycentrics[next++];
                    }
                    return judge(answered);
                  });
}

WitnessValue Listed(const std::array<double, 3>& barycentrics) {
  return {barycentrics[0], ", ", barycentrics[1], ", ", barycentrics[2]};
}

bool AreFinite(const std::array<double, 3>& barycentrics) {
  return std::ranges::all_of(barycentrics, [](double x) { return std::isfinite(x); });
}

Distance DistanceFromSumOne(const std::array<double, 3>& barycentrics, double bound) {
  using exact::Rational;
  const Estimate expected = Estimate(1) - Estimate(barycentrics[0]) - Estimate(barycentrics[1]);
  if (const auto near = CompareWithEstimate(barycentrics[2], expected, bound)) return *near;
  return CompareWithExact(
      barycentrics[2], Rational(1) - Rational(barycentrics[0]) - Rational(barycentrics[1]), bound);
}

std::string_view FormName(BarycentricForm form) {
  switch (form) {
    case BarycentricForm::kVertexArea:
      return "over the vertex area";
    case BarycentricForm::kSum:
      return "over the sum";
    case BarycentricForm::kOneMinus:
      return "one minus the others";
    case BarycentricForm::kUnsignedArea:
      return "unsigned areas";
  }
  return "";
}

std::array<exact::Rational, 3> ExactBarycentrics(const BarycentricQuery& q) {
  // The queries hold triangles of non-zero area only.
  return *exact::Barycentrics(q.v, q.place.at);
}

std::vector<std::array<double, 3>> SomeAttributes(const PlacedCase& c, const BarycentricQuery& q) {
  std::vector<std::array<double, 3>> sets{{0.25, 1, 0.625}, {3, 3, 3}};
  const std::array<Vertex, 3> v =
      Corners(c.scene, c.scene.triangles[static_cast<std::size_t>(q.triangle)]);
  const auto moderate = [](const Vertex& vertex) {
    return std::fabs(vertex.z) <= kLargestAttribute;  // NaN is not
  };
  const bool varies = v[0].z != v[1].z || v[1].z != v[2].z;
  if (varies && std::ranges::all_of(v, moderate)) sets.push_back({v[0].z, v[1].z, v[2].z});
  return sets;
}

Verdict BarycentricViolation(const BarycentricQuery& q, int entry, std::uint64_t exercised,
                             const std::string& property, WitnessValue observed,
                             WitnessValue expected) {
  return Verdict::Violated(
      exercised,
      property + ": triangle " + HexText(q.v[0]) + " " + HexText(q.v[1]) + " " + HexText(q.v[2]) +
          " at " + HexText(q.place.at),
      WitnessAt(q.triangle, entry, q.place, std::move(observed), std::move(expected)));
}

}  // namespace rasterproof::props
