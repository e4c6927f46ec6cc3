// E(v0, v1; v2), E(v1, v2; v0) and E(v2, v0; v1) are one number, up to the bounds stated for each.
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "props/judging/values/edge_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace cyclic_rotation_keeps_the_area {

constexpr int kTriangles = 64;

// The area of a triangle whose list starts with another vertex than the first.
struct Rotation {
  BoundedEdge edge;
  double area_bound = 0;
  std::size_t area = 0;     ///< among the answers
  std::size_t rotated = 0;  ///< among the answers
};

// Adds the rotations of a triangle, and what they ask.
void AddRotations(const CornersPlace& corners, const EdgeBounds& bounds,
                  std::vector<Rotation>& rotations, std::vector<EdgeQuestion>& questions) {
  const std::array<Point2, 3>& v = corners.at;
  const double area_bound = bounds.ErrorBound(v[0], v[1], v[2]);
  if (!IsStated(area_bound)) return;
  const std::size_t area = questions.size();
  questions.push_back({v[0], v[1], v[2]});
  for (int i = 0; i < 2; ++i) {
    const Point2 a = EdgeStart(v, i);
    const Point2 b = EdgeEnd(v, i);
    const Point2 apex = v[static_cast<std::size_t>(i)];
    const double bound = bounds.ErrorBound(a, b, apex);
    if (!IsStated(bound)) continue;
    const EdgeQuery query{corners.triangle, i, a, b, {-1, -1, 0, apex}};
    rotations.push_back({{query, bound}, area_bound, area, questions.size()});
    questions.push_back({a, b, apex});
  }
}

Verdict Judge(const std::vector<Rotation>& rotations, const Answers& answers) {
  std::uint64_t exercised = 0;
  for (const Rotation& rotation : rotations) {
    ++exercised;
    const auto& [q, bound] = rotation.edge;
    const double area = answers.edges[rotation.area];
    const double rotated = answers.edges[rotation.rotated];
    if (AgreeWithin(rotated, area, -1, bound, rotation.area_bound)) continue;
    return EdgeViolation(
        q, exercised, "twice the area depends on the first vertex", {rotated},
        {area, " within ", rotation.area_bound + bound, "; E = ", ExactEdge(q.a, q.b, q.place.at)});
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<Rotation> rotations;
  Questions questions;
  for (const CornersPlace& corners : SomeTriangles(c, kTriangles)) {
    AddRotations(corners, *subject.edges, rotations, questions.edges);
  }
  return OneCheck(std::move(questions), [rotations = std::move(rotations)](const Answers& answers) {
    return Judge(rotations, answers);
  });
}

}  // namespace cyclic_rotation_keeps_the_area

extern constinit const Property kCyclicRotationKeepsTheArea{
    .name = "CyclicRotationKeepsTheArea",
    .group = "edge",
    .clause = "E(v0, v1; v2) is twice the signed area, whichever vertex the list starts with.",
    .tolerance = kBothBounds,
    .domains = kMagnitudes,
    .gate = kAsksEdgeValues,
    .ask = cyclic_rotation_keeps_the_area::Ask,
};

}  // namespace rasterproof::props
