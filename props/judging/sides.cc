#include "props/judging/sides.h"

#include <algorithm>
#include <array>
#include <optional>

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

}  // namespace

Sides SidesOf(const Scene& scene, std::span<const Triangle> triangles, const Profile& profile) {
  const Profile model = ForTarget(profile, scene.width, scene.height);
  const Scene snapped = IsHomogeneous(scene, model) ? scene : SnapScene(scene, model);
  Sides sides;
  for (const Triangle& t : triangles) {
    (FacingOf(snapped, t, model) < 0 ? sides.back : sides.front).push_back(t);
  }
  return sides;
}

}  // namespace rasterproof::props
