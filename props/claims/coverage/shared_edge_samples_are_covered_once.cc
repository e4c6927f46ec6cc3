// Each sample beside an edge that two triangles share from either side is covered by one of them.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/neighbour_pairs.h"
#include "props/judging/planar_mesh.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& /*subject*/) {
  return CompareNeighbours(c, [](const Neighbours&) { return true; });
}

}  // namespace

constinit const Property kSharedEdgeSamplesAreCoveredOnce{
    .name = "SharedEdgeSamplesAreCoveredOnce",
    .group = "coverage",
    .clause =
        "Exactly one of two polygons on either side of a common edge with identical "
        "endpoints owns a sample on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic "
        "Polygon Rasterization).",
    .tolerance = kExact,
    .domains = kMeshesAnySpace,
    .gate = {.space = Space::kEither,
             .promise = Promise::kWatertight,
             .judges_clipped = true,
             .rules = kPlanarMeshRules,
             .asks_oracle = true,
             .where = "shared ties: at least once; two triangles of one facing with an edge in "
                      "opposite directions; samples to which no other edge of theirs is nearer"},
    .ask = Ask,
};

}  // namespace rasterproof::props
