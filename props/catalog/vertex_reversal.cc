#include "props/catalog/vertex_reversal.h"

#include <utility>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict ReversalSwapsFacing(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  Case reversed = c;
  for (Triangle& t : reversed.scene.triangles) t = {t[0], t[2], t[1]};
  CoverageCounts expected = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::swap(expected.front, expected.back);
  const CoverageCounts observed = Drawn(subject, reversed.scene, c.profile, WholeTarget(c));
  return SameCounts(observed, expected, DecisionsOf(c),
                    "the unreversed triangles', facing swapped,");
}

}  // namespace rasterproof::props
