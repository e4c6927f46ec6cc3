#include "exact/placed_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "model/snap_scene.h"

namespace rasterproof::exact {
namespace {

// Clip space: the area of the quotients on the grid, or of the given vertices if they have none.
int ClipFacing(const std::array<Vertex, 3>& v, const Snap& snap) {
  const std::optional<int> on_grid = SnappedClipFacing(v, snap);
  return on_grid ? *on_grid : HomogeneousFacing(v);
}

}  // namespace

PlacedScene::PlacedScene(Scene given, const Profile& stated)
    : scene(std::move(given)), profile(stated, scene) {
  Place();
  FindFacings();
}

void PlacedScene::Place() {
  if (!IsHomogeneous(scene, profile)) {
    placed = SnapVertices(scene, profile);
    return;
  }
  if (!PlacesClipSpace(profile)) {
    why_not_placed =
        InputError("profile \"" + profile.name + "\"",
                   "its fixed-point input, largest extent or rounded crossings need window space",
                   "give vertices [x, y]");
  } else if (!profile.snap.IsNone()) {
    why_not_placed = SnapClipError(scene, profile);
  }
  placed = profile.snap.IsNone() || why_not_placed ? scene : SnapClipScene(scene, profile);
}

void PlacedScene::FindFacings() {
  const int up = profile.y_axis == YAxis::kUp ? -1 : 1;
  facings.reserve(placed.triangles.size());
  for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(placed, placed.triangles[t]);
    int facing = 0;
    if (std::ranges::all_of(v, IsFinite)) {
      facing = placed.clip_space
                   ? ClipFacing(v, profile.snap)
                   : Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
      if (facing == 0) flat.push_back(t);
    }
    if (!placed.clip_space && IsDropped(placed, t, profile)) {
      Triangle& corners = placed.triangles[t];
      corners = {corners[0], corners[0], corners[0]};
      facing = 0;
    }
    facing *= up;
    if (AlwaysCulls(profile, facing)) {
      Triangle& corners = placed.triangles[t];
      corners = {corners[0], corners[0], corners[0]};
      facing = 0;
      culled.push_back(t);
    }
    facings.push_back(static_cast<std::int8_t>(facing));
  }
}

}  // namespace rasterproof::exact
