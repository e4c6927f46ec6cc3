#include "props/catalog/edge_antisymmetry.h"

#include <cstdint>
#include <optional>

#include "props/catalog/edge_queries.h"
#include "props/catalog/exact_comparison.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict ReversedEdgeChangesSign(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
