// Every edge value lies within the subject's own proven bound of E(a, b; p).
#include <algorithm>
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
namespace edge_error_stays_within_its_bound {

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<BoundedEdge> edges = SomeBoundedEdges(c, *subject.edges);
  Questions questions = ValuesAt(edges);
  return OneCheck(std::move(questions), [edges = std::move(edges)](const Answers& answers) {
    double worst = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto& [q, bound] = edges[k];
      const double value = answers.edges[k];
      const Point2 p = q.place.at;
      const Distance distance = CompareWithEdge(value, q.a, q.b, p, bound);
      if (!distance.within) {
        return EdgeViolation(q, k + 1, "edge value outside its proven bound", {value},
                             {"E = ", ExactEdge(q.a, q.b, p), " within ", bound});
      }
      worst = std::max(worst, distance.ratio);
    }
    return Verdict::Held(edges.size(), worst);
  });
}

}  // namespace edge_error_stays_within_its_bound

extern constinit const Property kEdgeErrorStaysWithinItsBound{
    .name = "EdgeErrorStaysWithinItsBound",
    .group = "edge",
    .clause =
        "An edge value is (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x), up to a proven "
        "rounding error (Shewchuk 1997; Ozaki et al., BIT 2016).",
    .tolerance = "the subject's proven ErrorBound",
    .domains = kMagnitudes,
    .gate = kAsksEdgeValues,
    .ask = edge_error_stays_within_its_bound::Ask,
};

}  // namespace rasterproof::props
