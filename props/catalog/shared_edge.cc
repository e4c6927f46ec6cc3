#include "props/catalog/shared_edge.h"

#include "props/catalog/neighbour_pairs.h"
#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"

namespace rasterproof::props {

Verdict SharedEdgeSamplesAreCoveredOnce(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .watertight_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (auto refusal = LeavesEdgesOpen(c.profile)) return *refusal;
  return PairsCoverOnce(subject, c, [](const Neighbours&) { return true; });
}

}  // namespace rasterproof::props
