// E(b, a; p) is -E(a, b; p), up to the sum of the bounds stated for both.
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
namespace reversed_edge_changes_sign {

struct EdgeBothWays {
  BoundedEdge edge;
  double reversed_bound = 0;
};

std::vector<EdgeBothWays> SomeEdgesBothWays(const PlacedCase& c, const EdgeBounds& bounds) {
  std::vector<EdgeBothWays> edges;
  for (const BoundedEdge& edge : SomeBoundedEdges(c, bounds)) {
    const EdgeQuery& q = edge.query;
    const double reversed_bound = bounds.ErrorBound(q.b, q.a, q.place.at);
    if (IsStated(reversed_bound)) edges.push_back({edge, reversed_bound});
  }
  return edges;
}

// Forwards, then reversed.
Questions ValuesOf(const std::vector<EdgeBothWays>& edges) {
  Questions questions;
  for (const auto& [edge, reversed_bound] : edges) {
    const EdgeQuery& q = edge.query;
    questions.edges.push_back({q.a, q.b, q.place.at});
    questions.edges.push_back({q.b, q.a, q.place.at});
  }
  return questions;
}

Verdict Judge(const std::vector<EdgeBothWays>& edges, const Answers& answers) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto& [edge, reversed_bound] = edges[k];
    const auto& [q, bound] = edge;
    const double value = answers.edges[2 * k];
    const double reversed = answers.edges[2 * k + 1];
    if (AgreeWithin(reversed, value, +1, reversed_bound, bound)) continue;
    return EdgeViolation(q, k + 1, "the reversed edge is not the negative", {reversed, " reversed"},
                         {-value, " within ", bound + reversed_bound,
                          "; E = ", ExactEdge(q.a, q.b, q.place.at), " forwards"});
  }
  return Verdict::Held(edges.size());
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<EdgeBothWays> edges = SomeEdgesBothWays(c, *subject.edges);
  Questions questions = ValuesOf(edges);
  return OneCheck(std::move(questions), [edges = std::move(edges)](const Answers& answers) {
    return Judge(edges, answers);
  });
}

}  // namespace reversed_edge_changes_sign

extern constinit const Property kReversedEdgeChangesSign{
    .name = "ReversedEdgeChangesSign",
    .group = "edge",
    .clause =
        "E(b, a; p) = -E(a, b; p): the determinant changes sign with the exchange of its ends.",
    .tolerance = "the sum of both proven ErrorBounds; where both are 0, none: exact",
    .domains = kNearEdges,
    .gate = kAsksEdgeValues,
    .ask = reversed_edge_changes_sign::Ask,
};

}  // namespace rasterproof::props
