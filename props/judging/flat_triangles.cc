#include "props/judging/flat_triangles.h"

#include <algorithm>
#include <array>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "model/snap_scene.h"

namespace rasterproof::props {
namespace {

bool HasNoArea(const Scene& scene, const std::array<Vertex, 3>& v) {
  if (scene.clip_space) return exact::HomogeneousFacing(v) == 0;
  return exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}) == 0;
}

// Clip space without places on the profile's grid stays as it is.
Scene Snapped(const Scene& scene, const Profile& profile) {
  if (!scene.clip_space) return SnapScene(scene, profile);
  const bool has_places = !profile.snap.IsNone() && !exact::SnapClipError(scene, profile);
  return has_places ? exact::SnapClipScene(scene, profile) : scene;
}

}  // namespace

std::vector<std::size_t> FlatTriangles(const Case& c) {
  // What the profile drops for its extent has an area all the same.
  Profile all_sizes = c.profile;
  all_sizes.max_primitive_extent.reset();
  const Scene snapped = Snapped(c.scene, all_sizes);
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < snapped.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(snapped, snapped.triangles[t]);
    if (std::ranges::all_of(v, IsFinite) && HasNoArea(snapped, v)) flat.push_back(t);
  }
  return flat;
}

}  // namespace rasterproof::props
