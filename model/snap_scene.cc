#include "model/snap_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/vertex.h"
#include "model/drop.h"
#include "model/snap.h"
#include "model/target_model.h"
#include "model/transform.h"
#include "model/wrap.h"

namespace rasterproof {

Scene SnapScene(const Scene& scene, const Profile& own) {
  Scene snapped = TakesToWindow(own, scene) ? ToWindow(scene, *own.transform) : scene;
  std::optional<Profile> resolved;
  const Profile& profile = own.by_target_size.empty()
                               ? own
                               : resolved.emplace(ForTarget(own, scene.width, scene.height));
  for (Vertex& v : snapped.vertices) {
    // A vertex without a place: its triangles cover nothing.
    if (profile.nan_z == NanZ::kNothing && std::isnan(v.z)) v.x = v.z;
    if (profile.fixed) v = {Wrapped(v.x, *profile.fixed), Wrapped(v.y, *profile.fixed), v.z, v.w};
    v.x = SnapCoordinate(v.x, profile.snap);
    v.y = SnapCoordinate(v.y, profile.snap);
  }
  // The grid point of a float32 can need more bits than float32 has.
  if (!profile.snap.IsNone()) snapped.precision = Precision::kFloat64;
  if (!profile.max_primitive_extent) return snapped;
  for (Triangle& t : snapped.triangles) {
    const std::array<Vertex, 3> v = Corners(snapped, t);
    const std::array<Point2, 3> corners{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    if (Exceeds(corners, *profile.max_primitive_extent)) t = {t[0], t[0], t[0]};
  }
  return snapped;
}

bool IsUnclipped(const Scene& scene, const Profile& profile) {
  const std::optional<WindowBox> box = UnclippedBox(profile, scene.width, scene.height);
  if (!box) return true;
  if (scene.clip_space) return false;  // the rectangle is of window space
  const auto holds = [&](const Scene& placed) {
    return std::ranges::all_of(placed.triangles, [&](const Triangle& t) {
      return std::ranges::all_of(Corners(placed, t),
                                 [&](const Vertex& v) { return box->Contains(v.x, v.y); });
    });
  };
  // Whether clipping looks at a vertex before or after snapping is left to the subject.
  Profile unsnapped = profile;
  unsnapped.snap = {};
  unsnapped.by_target_size.clear();
  return holds(SnapScene(scene, profile)) && holds(SnapScene(scene, unsnapped));
}

}  // namespace rasterproof
