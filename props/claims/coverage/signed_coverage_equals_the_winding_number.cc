// For any triangles, folded or not, front minus back equals the winding number of the boundary around the sample.
#include "model/snap_scene.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/free_choices.h"
#include "props/judging/mesh_model.h"
#include "props/judging/outline.h"
#include "props/judging/precondition.h"
#include "props/judging/signed_coverage.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
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

}  // namespace

constinit const Property kSignedCoverageEqualsTheWindingNumber{
    .name = "SignedCoverageEqualsTheWindingNumber",
    .group = "coverage",
    .clause =
        "Front minus back is the winding number of the boundary: every interior edge is "
        "walked once each way, and its two triangles decide it alike.",
    .precondition = "contract sample-exact; coordinates within the limit; a consistent fill rule",
    .tolerance = kExact,
    .domains = kAnyMesh,
    .check = Judge,
};

}  // namespace rasterproof::props
