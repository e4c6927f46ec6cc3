#include "props/catalog/clipped_neighbours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/scene.h"
#include "props/catalog/neighbour_pairs.h"
#include "props/catalog/planar_mesh.h"
#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kClipPairs = 6;

bool LeavesTarget(const Scene& scene, std::size_t triangle) {
  return std::ranges::any_of(Corners(scene, scene.triangles[triangle]), [&](const Vertex& v) {
    return v.x < 0 || v.x > scene.width || v.y < 0 || v.y > scene.height;
  });
}

bool PassesBehindTheEye(const Scene& scene, std::size_t triangle) {
  return std::ranges::any_of(Corners(scene, scene.triangles[triangle]),
                             [](const Vertex& v) { return v.w <= 0; });
}

// In clip space the expected counts are the model's: the union of two homogeneous triangles has no
// boundary in the plane to wind around.
Verdict ClipPairsCoverLikeTheModel(Subject& subject, const Case& c) {
  std::uint64_t exercised = 0;
  for (const Neighbours& pair : SharedEdges(c, kClipPairs)) {
    if (!PassesBehindTheEye(c.scene, pair.first) && !PassesBehindTheEye(c.scene, pair.second)) {
      continue;
    }
    Verdict verdict = JudgeAgainstTheModel(subject, OnlyTriangles(c, {pair.first, pair.second}));
    exercised += verdict.exercised;
    if (verdict.outcome != Outcome::kViolated) continue;
    verdict.exercised = exercised;
    verdict.witness->triangle = static_cast<int>(pair.first);
    verdict.witness->edge = pair.edge;
    verdict.message += " where triangles " + std::to_string(pair.first) + " and " +
                       std::to_string(pair.second) + " are cut by the plane of the eye";
    return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace

Verdict NeighboursAreClippedAlike(Subject& subject, const Case& c) {
  const Need need{
      .space = Space::kEither, .watertight_suffices = !c.scene.clip_space, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (c.scene.clip_space) return ClipPairsCoverLikeTheModel(subject, c);
  if (auto refusal = OwnsNoEdges(c.profile)) return *refusal;
  return PairsCoverOnce(subject, c, [&](const Neighbours& pair) {
    return LeavesTarget(c.scene, pair.first) || LeavesTarget(c.scene, pair.second);
  });
}

}  // namespace rasterproof::props
