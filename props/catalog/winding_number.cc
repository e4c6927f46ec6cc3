#include "props/catalog/winding_number.h"

#include "exact/winding.h"
#include "props/catalog/signed_coverage.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict SignedCoverageEqualsTheWindingNumber(Subject& subject, const Case& c) {
  const Need need{.space = Space::kWindow, .judges_clipped = true};
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, need)) return *refusal;
  const bool clipped = !IsUnclipped(c.scene, c.profile);
  Spared spared;
  if (clipped) {
    spared.open = OpenTriangles(c);
    spared.outline = Outline::OfMoved(c, spared.open.MostMoved());
    if (TellsFacings(subject)) spared.open.ForgetTurned();
  }
  Verdict verdict = SignedCoverageIs(subject, c, exact::BoundaryWinding(c.scene, c.profile),
                                     "the winding number of the boundary", spared);
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
