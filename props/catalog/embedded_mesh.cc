#include "props/catalog/embedded_mesh.h"

#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict EmbeddedMeshSamplesAreCoveredOnce(Subject& subject, const Case& c) {
  if (auto refusal =
          CannotJudgeCoverage(subject, c, {.space = Space::kWindow, .watertight_suffices = true})) {
    return *refusal;
  }
  if (!OwnsEdgesConsistently(c.profile)) {
    return Verdict::NotApplicable("an inclusive fill rule covers shared edges twice");
  }
  Verdict verdict = JudgePlanarMesh(subject, c, {});
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
