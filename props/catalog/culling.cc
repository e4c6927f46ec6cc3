#include "props/catalog/culling.h"

#include <algorithm>
#include <cstdint>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict CullingRemovesOneFacing(Subject& subject, const Case& c) {
  if (!subject.Info().takes_culling) return Verdict::NotApplicable("the subject does not cull");
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  const CoverageCounts whole = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    CoverageCounts expected = whole;
    std::ranges::fill(cull == Cull::kFront ? expected.front : expected.back, 0U);
    DrawOptions options = WholeTarget(c);
    options.cull = cull;
    const CoverageCounts observed = Drawn(subject, c.scene, c.profile, options);
    const Verdict verdict =
        SameCounts(observed, expected, DecisionsOf(c),
                   cull == Cull::kFront ? "the back counts alone" : "the front counts alone");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
