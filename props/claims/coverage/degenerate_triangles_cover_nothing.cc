// A triangle whose area is zero after snapping covers nothing.
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "model/snap_scene.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/flat_triangles.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (c.profile.zero_area == ZeroArea::kUnspecified) {
    return Verdict::NotApplicable("the profile leaves triangles of zero area unspecified");
  }
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  if (c.scene.clip_space && !c.profile.snap.IsNone()) {
    return {Outcome::kNotExercised, 0, 0, "the area after the division and snapping is not decided",
            std::nullopt};
  }
  const std::vector<std::size_t> flat = FlatTriangles(c);
  if (flat.empty()) return {Outcome::kNotExercised, 0, 0, "every triangle has area", std::nullopt};
  const Case alone = OnlyTriangles(c, flat);
  const CoverageCounts observed = Drawn(subject, alone.scene, c.profile, WholeTarget(c));
  const CoverageCounts nothing(c.scene.width, c.scene.height, c.profile.lattice.samples());
  Verdict verdict = SameCounts(observed, nothing, flat.size(), "none, the area is zero,");
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace

constinit const Property kDegenerateTrianglesCoverNothing{
    .name = "DegenerateTrianglesCoverNothing",
    .group = "coverage",
    .clause =
        "A triangle of zero area after snapping produces nothing (D3D11.3 functional "
        "specification, rasterizer; the profile says so).",
    .precondition = "contract sample-exact; coordinates within the limit; triangles of zero area",
    .tolerance = kExact,
    .domains = kDegenerate,
    .check = Judge,
};

}  // namespace rasterproof::props
