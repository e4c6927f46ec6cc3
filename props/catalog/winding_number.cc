#include "props/catalog/winding_number.h"

#include "exact/winding.h"
#include "props/catalog/signed_coverage.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict SignedCoverageEqualsTheWindingNumber(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, {.space = Space::kWindow}))
    return *refusal;
  Verdict verdict = SignedCoverageIs(subject, c, exact::BoundaryWinding(c.scene, c.profile),
                                     "the winding number of the boundary");
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
