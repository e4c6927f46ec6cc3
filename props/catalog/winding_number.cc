#include "props/catalog/winding_number.h"

#include "model/snap_scene.h"
#include "props/catalog/free_choices.h"
#include "props/catalog/mesh_model.h"
#include "props/catalog/outline.h"
#include "props/catalog/precondition.h"
#include "props/catalog/signed_coverage.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict SignedCoverageEqualsTheWindingNumber(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .judges_clipped = true};
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, need)) return *refusal;
  const bool clipped = !IsUnclipped(c.scene, c.profile);
  Spared spared;
  if (clipped) {
    spared.open = OpenTriangles(c);
    spared.outline = Outline::OfMoved(c, spared.open.MostMoved());
    if (TellsFacings(subject)) spared.open.ForgetTurned();
  }
  const char* const what = c.scene.clip_space ? "the winding number around the eye"
                                              : "the winding number of the boundary";
  Verdict verdict = SignedCoverageIs(subject, c, WindingOf(c), what, spared);
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
