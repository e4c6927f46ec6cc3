// E(v0, v1; v2), E(v1, v2; v0) and E(v2, v0; v1) are one number, up to the bounds claimed for each.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/edge_queries.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

constexpr int kTriangles = 64;

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  const EdgeEvaluator& edges = *subject.Edges();
  std::uint64_t exercised = 0;
  for (const CornersPlace& corners : SomeTriangles(c, kTriangles)) {
    const std::array<Point2, 3>& v = corners.at;
    const double bound = edges.ErrorBound(v[0], v[1], v[2]);
    if (!Claims(bound)) continue;
    const double area = edges.Value(v[0], v[1], v[2]);
    for (int i = 0; i < 2; ++i) {
      const Point2 a = EdgeStart(v, i);
      const Point2 b = EdgeEnd(v, i);
      const Point2 apex = v[static_cast<std::size_t>(i)];
      const double rotated_bound = edges.ErrorBound(a, b, apex);
      if (!Claims(rotated_bound)) continue;
      ++exercised;
      const double rotated = edges.Value(a, b, apex);
      if (AgreeWithin(rotated, area, -1, rotated_bound, bound)) continue;
      return EdgeViolation({corners.triangle, i, a, b, {-1, -1, 0, apex}}, exercised,
                           "twice the area depends on the first vertex", HexText(rotated),
                           HexText(area) + " within " + HexText(bound + rotated_bound) + "; " +
                               ExactEdgeText(a, b, apex));
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kCyclicRotationKeepsTheArea{
    .name = "CyclicRotationKeepsTheArea",
    .group = "edge",
    .clause = "Twice the signed area is E(v0, v1; v2) from whichever vertex it is told.",
    .precondition = kEdgeValues,
    .tolerance = kBothBounds,
    .domains = kMagnitudes,
    .check = Judge,
};

}  // namespace rasterproof::props
