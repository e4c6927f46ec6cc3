// Where |E| exceeds the bound that the subject states, its value has the sign of E.
//
// Where the subject claims an exact value, that is everywhere, zero included.
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "exact/edge.h"
#include "exact/rational.h"
#include "props/judging/values/edge_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace edge_sign_is_right_outside_its_band {

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<BoundedEdge> edges = SomeBoundedEdges(c, *subject.edges);
  Questions questions = ValuesAt(edges);
  return OneCheck(std::move(questions), [edges = std::move(edges)](const Answers& answers) {
    std::uint64_t exercised = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto& [q, bound] = edges[k];
      const double value = answers.edges[k];
      const Point2 p = q.place.at;
      if (HasSign(value, exact::EdgeSign(q.a, q.b, p))) {
        ++exercised;
        continue;
      }
      // A wrong sign: excused only within the band |E| <= bound, which a bound of 0 leaves empty.
      if (bound > 0 && exact::EdgeValue(q.a, q.b, p).Abs() <= exact::Rational(bound)) continue;
      ++exercised;
      return EdgeViolation(q, exercised, "wrong sign outside the proven band", {value},
                           {"E = ", ExactEdge(q.a, q.b, p), ", band ", bound});
    }
    return Verdict::Held(exercised);
  });
}

}  // namespace edge_sign_is_right_outside_its_band

extern constinit const Property kEdgeSignIsRightOutsideItsBand{
    .name = "EdgeSignIsRightOutsideItsBand",
    .group = "edge",
    .clause =
        "The sign of the edge function says on which side of an edge a sample lies (Pineda, "
        "SIGGRAPH 1988, section 3).",
    .tolerance = kOwnBound,
    .domains = kNearEdges,
    .gate = kAsksEdgeValues,
    .ask = edge_sign_is_right_outside_its_band::Ask,
};

}  // namespace rasterproof::props
