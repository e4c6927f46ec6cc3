#include "model/snap_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/vertex.h"
#include "model/drop.h"
#include "model/snap.h"
#include "model/transform.h"
#include "model/wrap.h"

namespace rasterproof {

Finiteness FinitenessOf(const std::array<Vertex, 3>& corners, const Profile& profile) {
  const auto any = [&](auto is) { return std::ranges::any_of(corners, is); };
  const auto unless = [](bool is_unspecified) {
    return is_unspecified ? Finiteness::kUnstated : Finiteness::kCoversNothing;
  };
  const bool has_nan_z = any([](const Vertex& v) { return std::isnan(v.z); });
  if (has_nan_z && profile.nan_z == NanZ::kNothing) return Finiteness::kCoversNothing;
  if (any([](const Vertex& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.w); }))
    return unless(profile.nan_vertex == NanVertex::kUnspecified);
  if (!std::ranges::all_of(corners, IsFinite))
    return unless(profile.infinite_vertex == InfiniteVertex::kUnspecified);
  const bool is_open = has_nan_z && profile.nan_z == NanZ::kUnspecified;
  return is_open ? Finiteness::kUnstated : Finiteness::kPlaced;
}

Scene SnapVertices(const Scene& scene, const TargetProfile& profile) {
  Scene snapped = TakesToWindow(profile, scene) ? ToWindow(scene, *profile.transform) : scene;
  for (Vertex& v : snapped.vertices) {
    // The vertex has no place: its triangles cover nothing.
    if (profile.nan_z == NanZ::kNothing && std::isnan(v.z)) v.x = v.z;
    if (profile.fixed) v = {Wrapped(v.x, *profile.fixed), Wrapped(v.y, *profile.fixed), v.z, v.w};
    v.x = SnapCoordinate(v.x, profile.snap);
    v.y = SnapCoordinate(v.y, profile.snap);
  }
  // The grid point of a float32 can need more bits than float32 has.
  if (!profile.snap.IsNone()) snapped.precision = Precision::kFloat64;
  return snapped;
}

bool IsDropped(const Scene& placed, std::size_t t, const Profile& profile) {
  if (!profile.max_primitive_extent) return false;
  const std::array<Vertex, 3> v = Corners(placed, placed.triangles[t]);
  return Exceeds({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])},
                 *profile.max_primitive_extent);
}

Scene SnapScene(const Scene& scene, const TargetProfile& profile) {
  Scene snapped = SnapVertices(scene, profile);
  for (std::size_t t = 0; t < snapped.triangles.size(); ++t) {
    Triangle& corners = snapped.triangles[t];
    if (IsDropped(snapped, t, profile)) corners = {corners[0], corners[0], corners[0]};
  }
  return snapped;
}

bool IsUnclipped(const Scene& scene, const TargetProfile& profile) {
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
  TargetProfile unsnapped = profile;
  unsnapped.snap = {};
  return holds(SnapScene(scene, profile)) && holds(SnapScene(scene, unsnapped));
}

}  // namespace rasterproof
