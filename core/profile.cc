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
  profile.infinite_vertex = InfiniteVertex::kUnspecified;
  if (name == "d3d11") return profile;
  if (name == "vulkan" || name == "gl") return profile;
  return std::nullopt;
}

// All that is not named here is of the model, keys of a later day too.
bool SameModel(const Profile& a, const Profile& b) {
  Profile judged_alike = a;
  judged_alike.name = b.name;
  judged_alike.contract = b.contract;
  judged_alike.freedom = b.freedom;
  judged_alike.coordinate_limit = b.coordinate_limit;
  judged_alike.degenerate_triangles = b.degenerate_triangles;
  judged_alike.infinite_vertex = b.infinite_vertex;
  judged_alike.shares_edge_samples = b.shares_edge_samples;
  judged_alike.guard_band = b.guard_band;
  return judged_alike == b;
}

bool WithinLimits(const Scene& scene, const Profile& profile) {
  return CanBeGiven(scene, profile) && std::ranges::all_of(scene.vertices, [&](const Vertex& v) {
           return IsFinite(v) && std::fabs(v.x) <= profile.coordinate_limit &&
                  std::fabs(v.y) <= profile.coordinate_limit;
         });
}

bool CanBeGiven(const Scene& scene, const Profile& profile) {
  if (!profile.fixed) return true;
  const FixedInput& fixed = *profile.fixed;
  return !scene.clip_space && std::ranges::all_of(scene.vertices, [&](const Vertex& v) {
    return fixed.IsGiven(v.x) && fixed.IsGiven(v.y);
  });
}

bool IsUnwrapped(const Scene& scene, const Profile& profile) {
  if (!profile.fixed) return true;
  const FixedInput& fixed = *profile.fixed;
  return std::ranges::all_of(
      scene.vertices, [&](const Vertex& v) { return fixed.InRange(v.x) && fixed.InRange(v.y); });
}

}  // namespace rasterproof
