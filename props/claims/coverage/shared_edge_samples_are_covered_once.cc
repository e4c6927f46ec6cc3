// Near an edge that two triangles share from either side, each sample of their union is covered by exactly one of them.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/neighbour_pairs.h"
#include "props/judging/planar_mesh.h"
#include "props/judging/precondition.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .watertight_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (auto refusal = LeavesEdgesOpen(c.profile)) return *refusal;
  return PairsCoverOnce(subject, c, [](const Neighbours&) { return true; });
}

}  // namespace

constinit const Property kSharedEdgeSamplesAreCoveredOnce{
    .name = "SharedEdgeSamplesAreCoveredOnce",
    .group = "coverage",
    .clause =
        "Exactly one of two polygons on either side of a common edge with identical "
        "endpoints owns a sample on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic "
        "Polygon Rasterization).",
    .precondition = kSharedEdges,
    .tolerance = kExact,
    .domains = kMeshesAnySpace,
    .check = Judge,
};

}  // namespace rasterproof::props
