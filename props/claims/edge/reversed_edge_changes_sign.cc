// E(b, a; p) is -E(a, b; p), up to the sum of the bounds claimed for both.
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

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  const EdgeEvaluator& edges = *subject.Edges();
  std::uint64_t exercised = 0;
  for (const auto& [q, value, bound] : ClaimedEdgeValues(edges, c)) {
    const Point2 p = q.place.at;
    const double reversed_bound = edges.ErrorBound(q.b, q.a, p);
    if (!Claims(reversed_bound)) continue;
    ++exercised;
    const double reversed = edges.Value(q.b, q.a, p);
    if (AgreeWithin(reversed, value, +1, reversed_bound, bound)) continue;
    return EdgeViolation(q, exercised, "the reversed edge is not the negative",
                         HexText(reversed) + " reversed",
                         HexText(-value) + " within " + HexText(bound + reversed_bound) + "; " +
                             ExactEdgeText(q.a, q.b, p) + " forwards");
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kReversedEdgeChangesSign{
    .name = "ReversedEdgeChangesSign",
    .group = "edge",
    .clause =
        "E(b, a; p) = -E(a, b; p): the determinant changes sign with the exchange of its ends.",
    .precondition = kEdgeValues,
    .tolerance = "the sum of both proven ErrorBounds; where both are 0, none: exact",
    .domains = kNearEdges,
    .check = Judge,
};

}  // namespace rasterproof::props
