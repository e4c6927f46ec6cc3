// For any triangles, folded or not, front minus back is the boundary's winding number.
#include <utility>

#include "model/snap_scene.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/mesh/mesh_model.h"
#include "props/judging/mesh/signed_coverage.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace signed_coverage_equals_the_winding_number {

Checks Ask(const PlacedCase& c, const Description& subject) {
  Spared spared;
  if (!IsUnclipped(c.scene, c.profile)) {
    spared.open = OpenTriangles(c);
    spared.outline = Outline::OfMoved(c, spared.open.MostMoved());
    if (TellsFacings(subject)) spared.open.ForgetTurned();
  }
  const char* const what = c.scene.clip_space ? "the winding number around the eye"
                                              : "the winding number of the boundary";
  return CompareSignedCoverage(c, WindingOf(c), what, std::move(spared));
}

}  // namespace signed_coverage_equals_the_winding_number

extern constinit const Property kSignedCoverageEqualsTheWindingNumber{
    .name = "SignedCoverageEqualsTheWindingNumber",
    .group = "coverage",
    .clause =
        "Front minus back is the winding number of the boundary: every interior edge is "
        "walked once each way, and its two triangles decide it alike.",
    .required_by = kEveryEdgeClauses,
    .tolerance = kExact,
    .domains = kAnyMeshAndTurned,
    .gate = {.space = Space::kEither,
             .judges_clipped = true,
             .needs_facings = true,
             .rules = kSignedCoverageRules,
             .asks_oracle = true},
    .ask = signed_coverage_equals_the_winding_number::Ask,
    .blame = [](const PlacedCase& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, WholeTarget(c)); },
};

}  // namespace rasterproof::props
