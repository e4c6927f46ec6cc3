#include "props/catalog/closed_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/winding.h"
#include "props/catalog/signed_coverage.h"

namespace rasterproof::props {

Verdict ClosedMeshCancels(Subject& subject, const Case& c) {
  const Need need{.space = Space::kWindow,
                  .closed_suffices = true,
                  .any_model_suffices = true,
                  .judges_clipped = true};
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, need)) return *refusal;
  // What is closed before it is snapped stays closed, whatever grid points are chosen.
  Profile unsnapped = c.profile;
  unsnapped.snap.bits = Snap::kNone;
  unsnapped.targets.clear();
  if (!exact::ShapeOf(c.scene, HasOneModel(c.profile) ? c.profile : unsnapped).closed) {
    return {Outcome::kNotExercised, 0, 0, "the mesh has a boundary", std::nullopt};
  }
  const std::size_t size =
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.lattice.samples());
  return SignedCoverageIs(subject, c, std::vector<std::int64_t>(size), "zero, the mesh is closed");
}

}  // namespace rasterproof::props
