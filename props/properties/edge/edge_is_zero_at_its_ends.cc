// E(a, b; a) and E(a, b; b) are zero up to the bound stated there: exactly, where that is zero.
#include <cmath>
#include <cstddef>
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
namespace edge_is_zero_at_its_ends {

constexpr int kTriangles = 64;

std::vector<BoundedEdge> EndsOfEdges(const PlacedCase& c, const EdgeBounds& bounds) {
  std::vector<BoundedEdge> ends;
  for (const CornersPlace& corners : SomeTriangles(c, kTriangles)) {
    for (int i = 0; i < 3; ++i) {
      const Point2 a = EdgeStart(corners.at, i);
      const Point2 b = EdgeEnd(corners.at, i);
      for (const Point2 end : {a, b}) {
        const double bound = bounds.ErrorBound(a, b, end);
        if (IsStated(bound)) ends.push_back({{corners.triangle, i, a, b, {-1, -1, 0, end}}, bound});
      }
    }
  }
  return ends;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<BoundedEdge> ends = EndsOfEdges(c, *subject.edges);
  Questions questions = ValuesAt(ends);
  return OneCheck(std::move(questions), [ends = std::move(ends)](const Answers& answers) {
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const auto& [q, bound] = ends[k];
      const double value = answers.edges[k];
      if (std::fabs(value) <= bound) continue;  // NaN is not
      return EdgeViolation(q, k + 1, "not zero at an end of the edge", {value},
                           {std::int64_t{0}, " within ", bound});
    }
    return Verdict::Held(ends.size());
  });
}

}  // namespace edge_is_zero_at_its_ends

extern constinit const Property kEdgeIsZeroAtItsEnds{
    .name = "EdgeIsZeroAtItsEnds",
    .group = "edge",
    .clause = "An edge line passes through its ends: E(a, b; a) = E(a, b; b) = 0.",
    .tolerance = kOwnBound,
    .domains = kMagnitudes,
    .gate = kAsksEdgeValues,
    .ask = edge_is_zero_at_its_ends::Ask,
};

}  // namespace rasterproof::props
