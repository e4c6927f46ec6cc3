#include "props/catalog/edge_sign.h"

#include <cstdint>
#include <optional>

#include "exact/edge.h"
#include "exact/rational.h"
#include "props/catalog/edge_queries.h"
#include "props/catalog/exact_comparison.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict EdgeSignIsRightOutsideItsBand(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  for (const auto& [q, value, bound] : ClaimedEdgeValues(*subject.Edges(), c)) {
    const Point2 p = q.place.at;
    if (HasSign(value, exact::EdgeSign(q.a, q.b, p))) {
      ++exercised;
      continue;
    }
    // A wrong sign: excused only within the band |E| <= bound, which a bound of 0 leaves empty.
    if (bound > 0 && exact::EdgeValue(q.a, q.b, p).Abs() <= exact::Rational(bound)) continue;
    ++exercised;
    return EdgeViolation(q, exercised, "wrong sign outside the proven band", HexText(value),
                         ExactEdgeText(q.a, q.b, p) + ", band " + HexText(bound));
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
