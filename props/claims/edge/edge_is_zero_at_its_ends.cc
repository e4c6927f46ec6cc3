// E(a, b; a) and E(a, b; b) are zero up to the bound claimed there: exactly, where the subject claims to be exact.
#include <cmath>
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
    for (int i = 0; i < 3; ++i) {
      const Point2 a = EdgeStart(corners.at, i);
      const Point2 b = EdgeEnd(corners.at, i);
      for (const Point2 end : {a, b}) {
        const double bound = edges.ErrorBound(a, b, end);
        if (!Claims(bound)) continue;
        ++exercised;
        const double value = edges.Value(a, b, end);
        if (std::fabs(value) <= bound) continue;  // NaN is not
        return EdgeViolation({corners.triangle, i, a, b, {-1, -1, 0, end}}, exercised,
                             "not zero at an end of the edge", HexText(value),
                             "0 within " + HexText(bound));
      }
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kEdgeIsZeroAtItsEnds{
    .name = "EdgeIsZeroAtItsEnds",
    .group = "edge",
    .clause = "An edge line passes through its ends: E(a, b; a) = E(a, b; b) = 0.",
    .precondition = kEdgeValues,
    .tolerance = kOwnBound,
    .domains = kMagnitudes,
    .check = Judge,
};

}  // namespace rasterproof::props
