// Two triangles cover each sample near their common edge as often clipped as unclipped.
//
// At least one of them leaves the target or passes behind the eye. No clause asks for it: each of
// the two may take its own new vertex on the edge.
#include <algorithm>
#include <cstddef>

#include "core/scene.h"
#include "props/judging/mesh/planar_mesh.h"
#include "props/placed_case.h"
#include "props/properties/coverage/shared_edge_samples_are_covered_once.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace neighbours_are_clipped_alike {

// In clip space |x / w| against the target's sides; the product may round: it is a choice of pairs.
bool IsSeenOutside(const Vertex& v, const Scene& scene) {
  if (v.w <= 0) return true;
  return v.x < 0 || v.x > scene.width * v.w || v.y < 0 || v.y > scene.height * v.w;
}

bool LeavesTarget(const Scene& scene, std::size_t triangle) {
  return std::ranges::any_of(Corners(scene, scene.triangles[triangle]),
                             [&](const Vertex& v) { return IsSeenOutside(v, scene); });
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CoverSharedEdgesOnce(c, subject, Clipped::kAlike, [&](const Neighbours& pair) {
    return LeavesTarget(c.scene, pair.first) || LeavesTarget(c.scene, pair.second);
  });
}

}  // namespace neighbours_are_clipped_alike

extern constinit const Property kNeighboursAreClippedAlike{
    .name = "NeighboursAreClippedAlike",
    .group = "coverage",
    .clause =
        "A shared edge is clipped alike for both of its triangles: no gap opens and nothing "
        "doubles where they leave the target.",
    .tolerance = kExact,
    .domains = kClipped,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kWatertight,
             .judges_clipped = true,
             .rules = kPlanarMeshRules,
             .asks_oracle = true,
             .where = "shared ties: at least once; an edge shared in opposite directions by "
                      "triangles of one facing of which one leaves the target or passes behind the "
                      "eye; samples nearer to it than to any other edge of theirs"},
    .ask = neighbours_are_clipped_alike::Ask,
};

}  // namespace rasterproof::props
