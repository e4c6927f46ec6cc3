#include "props/catalog/edge_sign.h"

#include <cstdint>
#include <optional>

#include "exact/edge.h"
#include "exact/rational.h"
#include "props/catalog/edge_queries.h"
#include "props/catalog/exact_comparison.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

int SignOf(double x) { return (x > 0) - (x < 0); }

}  // namespace

Verdict EdgeSignIsRightOutsideItsBand(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  const EdgeEvaluator& edges = *subject.Edges();
  std::uint64_t exercised = 0;
  for (const EdgeQuery& q : SomeEdgeQueries(c)) {
    const Point2 p = q.place.at;
    const double bound = edges.ErrorBound(q.a, q.b, p);
    if (!Claims(bound)) continue;
    const double value = edges.Value(q.a, q.b, p);
    const int sign = exact::EdgeSign(q.a, q.b, p);
    if (SignOf(value) == sign && value == value) {
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
