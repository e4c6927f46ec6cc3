#include "props/catalog/edge_error.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "props/catalog/edge_queries.h"
#include "props/catalog/exact_comparison.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict EdgeErrorStaysWithinItsBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const auto& [q, value, bound] : ClaimedEdgeValues(*subject.Edges(), c)) {
    const Point2 p = q.place.at;
    ++exercised;
    const Distance distance = CompareWithEdge(value, q.a, q.b, p, bound);
    if (!distance.within) {
      return EdgeViolation(q, exercised, "edge value outside its proven bound", HexText(value),
                           ExactEdgeText(q.a, q.b, p) + " within " + HexText(bound));
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
