#include "props/catalog/clipped_neighbours.h"

#include <algorithm>
#include <cstddef>

#include "core/scene.h"
#include "props/catalog/neighbour_pairs.h"
#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"

namespace rasterproof::props {
namespace {

// In clip space |x / w| against the target's sides; the product may round: it is a choice of pairs.
bool IsSeenOutside(const Vertex& v, const Scene& scene) {
  if (v.w <= 0) return true;
  return v.x < 0 || v.x > scene.width * v.w || v.y < 0 || v.y > scene.height * v.w;
}

bool LeavesTarget(const Scene& scene, std::size_t triangle) {
  return std::ranges::any_of(Corners(scene, scene.triangles[triangle]),
                             [&](const Vertex& v) { return IsSeenOutside(v, scene); });
}

}  // namespace

Verdict NeighboursAreClippedAlike(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .watertight_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (auto refusal = LeavesEdgesOpen(c.profile)) return *refusal;
  return PairsCoverOnce(subject, c, [&](const Neighbours& pair) {
    return LeavesTarget(c.scene, pair.first) || LeavesTarget(c.scene, pair.second);
  });
}

}  // namespace rasterproof::props
