// Where the subject claims both its walk and its direct evaluation to be exact, they give the same number at every step.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/walks.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWalks(subject, c)) return *refusal;
  const EdgeEvaluator& edges = *subject.Edges();
  std::uint64_t exercised = 0;
  for (const WalkQuery& walk : SomeWalks(c)) {
    const EdgeQuery& q = walk.from;
    const std::vector<double> values = edges.Walk(q.a, q.b, q.place.at, walk.step, walk.steps);
    const std::vector<double> bounds =
        edges.WalkErrorBounds(q.a, q.b, q.place.at, walk.step, walk.steps);
    if (auto wrong = WrongLength(walk, values.size(), bounds.size(), exercised)) return *wrong;
    for (int n = 0; n <= walk.steps; ++n) {
      const auto k = static_cast<std::size_t>(n);
      const Point2 p = AfterSteps(walk, n);
      if (bounds[k] != 0 || edges.ErrorBound(q.a, q.b, p) != 0) continue;
      ++exercised;
      const double direct = edges.Value(q.a, q.b, p);
      if (values[k] == direct) continue;
      return EdgeViolation(
          q, exercised, "walk differs from direct evaluation " + StepsText(walk, n),
          HexText(values[k]), HexText(direct) + " evaluated afresh; " + ExactEdgeText(q.a, q.b, p));
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kWalkEqualsDirectWhereExact{
    .name = "WalkEqualsDirectWhereExact",
    .group = "incremental",
    .clause =
        "Incremental equals direct evaluation wherever the arithmetic is exact (Pineda, "
        "SIGGRAPH 1988, section 3.2).",
    .precondition =
        "the subject shows edge values and claims a finite bound there; window space "
        "within the limits; both claimed bounds are 0",
    .tolerance = kExact,
    .domains = kOnTheLattice,
    .check = Judge,
};

}  // namespace rasterproof::props
