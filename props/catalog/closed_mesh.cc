#include "props/catalog/closed_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/winding.h"
#include "props/catalog/mesh_neighbours.h"
#include "props/catalog/signed_coverage.h"

namespace rasterproof::props {
namespace {

// What is closed before it is snapped stays closed, whatever grid points are chosen.
bool IsClosedUnderEveryChoice(const Case& c) {
  if (c.scene.clip_space) return IsClosed(c.scene);
  Profile unsnapped = c.profile;
  unsnapped.snap.bits = Snap::kNone;
  unsnapped.targets.clear();
  return exact::ShapeOf(c.scene, HasOneModel(c.profile) ? c.profile : unsnapped).closed;
}

}  // namespace

Verdict ClosedMeshCancels(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither,
                  .closed_suffices = true,
                  .any_model_suffices = true,
                  .judges_clipped = true};
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, need)) return *refusal;
  if (std::ranges::any_of(c.scene.vertices, [](const Vertex& v) { return !(v.w > 0); })) {
    return {Outcome::kNotExercised, 0, 0, "the surface may wind around the eye", std::nullopt};
  }
  if (!IsClosedUnderEveryChoice(c)) {
    return {Outcome::kNotExercised, 0, 0, "the mesh has a boundary", std::nullopt};
  }
  const std::size_t size =
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.lattice.samples());
  return SignedCoverageIs(subject, c, std::vector<std::int64_t>(size), "zero, the mesh is closed");
}

}  // namespace rasterproof::props
