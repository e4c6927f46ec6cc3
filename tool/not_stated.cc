#include "tool/not_stated.h"

#include <string_view>

#include "exact/placed_scene.h"
#include "model/snap_scene.h"

namespace rasterproof::tool {
namespace {

constexpr std::string_view kNotJudged = ": observed, not judged";

}  // namespace

std::string WhyNotStated(const Scene& scene, const Profile& profile) {
  if (auto why = WhyNotWithinLimits(scene, profile)) return *why + std::string(kNotJudged);
  if (!IsUnclipped(scene, {profile, scene})) {
    return "triangles leave the profile's guard-band rectangle" + std::string(kNotJudged);
  }
  if (profile.degenerate_triangles == DegenerateTriangles::kNothing) return "";
  if (scene.clip_space && !profile.snap.IsNone()) {
    return "areas after the division and snapping are not decided" + std::string(kNotJudged);
  }
  return exact::PlacedScene(scene, profile).flat.empty()
             ? ""
             : "triangles of zero area, which the profile leaves unspecified" +
                   std::string(kNotJudged);
}

}  // namespace rasterproof::tool
