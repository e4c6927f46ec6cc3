#include "props/catalog/walk_exact.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "props/catalog/walks.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict WalkEqualsDirectWhereExact(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
