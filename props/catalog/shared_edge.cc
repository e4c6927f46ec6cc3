#include "props/catalog/shared_edge.h"

#include "props/catalog/neighbour_pairs.h"
#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"

namespace rasterproof::props {

Verdict SharedEdgeSamplesAreCoveredOnce(Subject& subject, const Case& c) {
  if (auto refusal =
          CannotJudgeCoverage(subject, c, {.space = Space::kWindow, .watertight_suffices = true})) {
    return *refusal;
  }
  if (!OwnsEdgesConsistently(c.profile)) {
    return Verdict::NotApplicable("an inclusive fill rule covers shared edges twice");
  }
  return PairsCoverOnce(subject, c, [](const Neighbours&) { return true; });
}

}  // namespace rasterproof::props
