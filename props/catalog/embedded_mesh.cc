#include "props/catalog/embedded_mesh.h"

#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict EmbeddedMeshSamplesAreCoveredOnce(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .watertight_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (auto refusal = LeavesEdgesOpen(c.profile)) return *refusal;
  Verdict verdict = JudgePlanarMesh(subject, c, {});
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
