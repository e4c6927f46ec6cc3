#include "props/catalog/closed_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/profile.h"
#include "exact/winding.h"
#include "model/snap_scene.h"
#include "props/catalog/free_choices.h"
#include "props/catalog/mesh_neighbours.h"
#include "props/catalog/signed_coverage.h"

namespace rasterproof::props {
namespace {

// What is closed before it is snapped stays closed, whatever grid points are chosen.
bool IsClosedInEveryModel(const Case& c) {
  if (c.scene.clip_space) return IsClosed(c.scene);
  const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
  if (one_model) return exact::ShapeOf(c.scene, c.profile).closed;
  Profile as_it_is;
  as_it_is.lattice = c.profile.lattice;
  return exact::ShapeOf(UnsnappedScene(c), as_it_is).closed;
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
  const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
  if (!IsClosedInEveryModel(c))
    return {Outcome::kNotExercised, 0, 0, "the mesh has a boundary", std::nullopt};
  Spared spared;
  if (!one_model) {
    spared.open = OpenTriangles(c);
    // A surface that is turned in part still cancels, by the facings that the subject itself gives
    // its triangles; what covers something without area need not.
    const bool turns_cancel = TellsFacings(subject) && c.profile.zero_area == ZeroArea::kNothing;
    if (turns_cancel) spared.open.ForgetTurned();
  }
  const std::size_t size =
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.lattice.samples());
  return SignedCoverageIs(subject, c, std::vector<std::int64_t>(size), "zero, the mesh is closed",
                          spared);
}

}  // namespace rasterproof::props
