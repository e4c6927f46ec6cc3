#include "core/profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace rasterproof {

std::optional<Profile> PresetProfile(std::string_view name) {
  Profile profile;
  profile.name = name;
  if (name == "real") return profile;
  // The three APIs agree on the canonical model; what each leaves free is a matter of judging, not
  // of the model. Limits: D3D11 guard band, Vulkan's and GL's smallest guaranteed viewport bounds
  // range.
  profile.snap = {8, SnapRule::kNearestEven};
  profile.coordinate_limit = 0x1p15;
  if (name == "d3d11") return profile;
  if (name == "vulkan" || name == "gl") return profile;
  return std::nullopt;
}

Scene SnapScene(const Scene& scene, const Profile& profile) {
  Scene snapped =
      scene.clip_space && profile.transform ? ToWindow(scene, *profile.transform) : scene;
  if (profile.snap.IsNone()) return snapped;
  // The grid point of a float32 can need more bits than float32 has.
  snapped.precision = Precision::kFloat64;
  for (Vertex& v : snapped.vertices) {
    v.x = SnapCoordinate(v.x, profile.snap);
    v.y = SnapCoordinate(v.y, profile.snap);
  }
  return snapped;
}

bool WithinLimits(const Scene& scene, const Profile& profile) {
  return std::ranges::all_of(scene.vertices, [&](const Vertex& v) {
    return IsFinite(v) && std::fabs(v.x) <= profile.coordinate_limit &&
           std::fabs(v.y) <= profile.coordinate_limit;
  });
}

}  // namespace rasterproof
