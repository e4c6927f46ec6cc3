#include "props/run/parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "model/snap_scene.h"
#include "model/target_model.h"

namespace rasterproof::props {
namespace {

// +1 front, -1 back, 0 no area or not finite. Clip space: of the quotients on the grid; of the
// vertices as given if there is no grid, or a vertex has no place on it.
int FacingOf(const Scene& snapped, const Triangle& t, const Profile& profile) {
  const std::array<Vertex, 3> v = Corners(snapped, t);
  if (!std::ranges::all_of(v, IsFinite)) return 0;
  const auto homogeneous = [&] {
    const std::optional<int> on_grid = exact::SnappedClipFacing(v, profile.snap);
    return on_grid ? *on_grid : exact::HomogeneousFacing(v);
  };
  const int facing = snapped.clip_space
                         ? homogeneous()
                         : exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
  return profile.y_axis == YAxis::kUp ? -facing : facing;
}

DrawJob WithTriangles(const DrawJob& job, std::vector<Triangle> triangles) {
  DrawJob part = job;
  part.triangles = std::move(triangles);
  part.wants = kCoverageAndIds;  // that an id is of the scene is looked at, whoever asks
  return part;
}

}  // namespace

std::vector<Part> FacingParts(const DrawJob& job, CoverageKind coverage, const Profile& profile) {
  if (coverage == CoverageKind::kFacingCounts) return {{job, false}};
  const Scene& scene = *job.scene;
  const Profile model = ForTarget(profile, scene.width, scene.height);
  const Scene snapped = IsHomogeneous(scene, model) ? scene : SnapScene(scene, model);
  std::array<std::vector<Triangle>, 2> sides;
  for (const Triangle& t : job.Triangles()) {
    sides[FacingOf(snapped, t, model) < 0 ? 1 : 0].push_back(t);
  }
  std::vector<Part> parts;
  for (const bool is_back : {false, true}) {
    std::vector<Triangle>& side = sides[is_back ? 1 : 0];
    if (coverage == CoverageKind::kCounts) {
      if (!side.empty()) parts.push_back({WithTriangles(job, std::move(side)), is_back});
      continue;
    }
    for (const Triangle& t : side) parts.push_back({WithTriangles(job, {t}), is_back});
  }
  return parts;
}

void AddPart(const Part& part, CoverageKind coverage, const CoverageCounts& drawn,
             CoverageCounts& counts) {
  if (coverage == CoverageKind::kFacingCounts) {
    counts += drawn;
    return;
  }
  std::vector<std::uint32_t>& side = part.is_back ? counts.back : counts.front;
  for (std::size_t k = 0; k < side.size(); ++k) side[k] += drawn.Count(k);
}

}  // namespace rasterproof::props
