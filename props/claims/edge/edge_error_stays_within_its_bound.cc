// Every edge value lies within the subject's own proven bound of E(a, b; p).
#include <algorithm>
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

}  // namespace

constinit const Property kEdgeErrorStaysWithinItsBound{
    .name = "EdgeErrorStaysWithinItsBound",
    .group = "edge",
    .clause =
        "An edge value is (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x), up to a proven "
        "rounding error (Shewchuk 1997; Ozaki et al., BIT 2016).",
    .precondition = kEdgeValues,
    .tolerance = "the subject's proven ErrorBound",
    .domains = kMagnitudes,
    .check = Judge,
};

}  // namespace rasterproof::props
