#include "props/catalog/embedded_mesh.h"

#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"

namespace rasterproof::props {

Verdict EmbeddedMeshSamplesAreCoveredOnce(Subject& subject, const Case& c) {
  if (auto refusal =
          CannotJudgeCoverage(subject, c, {.space = Space::kWindow, .watertight_suffices = true})) {
    return *refusal;
  }
  if (!OwnsEdgesConsistently(c.profile)) {
    return Verdict::NotApplicable("an inclusive fill rule covers shared edges twice");
  }
  return JudgePlanarMesh(subject, c, {});
}

}  // namespace rasterproof::props
