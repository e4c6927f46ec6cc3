#include "core/profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace rasterproof {
namespace {

// Whether high - low > most, though the difference rounds: rounding keeps the order, and where it
// ends on `most` itself what was lost (Knuth's TwoSum) has the sign of the rest.
bool DifferenceExceeds(double high, double low, double most) {
  const double difference = high - low;
  if (difference != most || !std::isfinite(difference)) return difference > most;
  const double from_low = difference - high;
  return (high - (difference - from_low)) - (low + from_low) > 0;
}

}  // namespace

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

Profile ForTarget(const Profile& profile, int width, int height) {
  if (profile.targets.empty()) return profile;
  Profile resolved = profile;
  // What holds where no entry fits becomes the last one: so another size can still be asked about.
  if (!profile.targets.back().Fits(kMaxTargetSide, kMaxTargetSide)) {
    resolved.targets.push_back(
        {kMaxTargetSide, kMaxTargetSide, profile.snap, profile.lattice, profile.fill_rule});
  }
  const TargetModel model = *std::ranges::find_if(
      resolved.targets, [&](const TargetModel& entry) { return entry.Fits(width, height); });
  resolved.snap = model.snap;
  resolved.lattice = model.lattice;
  resolved.fill_rule = model.fill_rule;
  return resolved;
}

bool Exceeds(const std::array<Point2, 3>& corners, const MaxExtent& extent) {
  const auto [left, right] = std::ranges::minmax(corners, {}, &Point2::x);
  const auto [low, high] = std::ranges::minmax(corners, {}, &Point2::y);
  return DifferenceExceeds(right.x, left.x, extent.width) ||
         DifferenceExceeds(high.y, low.y, extent.height);
}

Scene SnapScene(const Scene& scene, const Profile& own) {
  Scene snapped = scene.clip_space && own.transform ? ToWindow(scene, *own.transform) : scene;
  std::optional<Profile> resolved;
  const Profile& profile =
      own.targets.empty() ? own : resolved.emplace(ForTarget(own, scene.width, scene.height));
  for (Vertex& v : snapped.vertices) {
    if (profile.fixed) v = {profile.fixed->Wrapped(v.x), profile.fixed->Wrapped(v.y), v.z, v.w};
    v.x = SnapCoordinate(v.x, profile.snap);
    v.y = SnapCoordinate(v.y, profile.snap);
  }
  // The grid point of a float32 can need more bits than float32 has.
  if (!profile.snap.IsNone()) snapped.precision = Precision::kFloat64;
  if (!profile.max_extent) return snapped;
  for (Triangle& t : snapped.triangles) {
    const std::array<Vertex, 3> v = Corners(snapped, t);
    const std::array<Point2, 3> corners{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    if (Exceeds(corners, *profile.max_extent)) t = {t[0], t[0], t[0]};
  }
  return snapped;
}

// All that is not named here is of the model, keys of a later day too.
bool SameModel(const Profile& a, const Profile& b) {
  Profile judged_alike = a;
  judged_alike.name = b.name;
  judged_alike.contract = b.contract;
  judged_alike.freedom = b.freedom;
  judged_alike.coordinate_limit = b.coordinate_limit;
  judged_alike.zero_area = b.zero_area;
  judged_alike.infinite_vertex = b.infinite_vertex;
  judged_alike.overdraw = b.overdraw;
  judged_alike.no_clip = b.no_clip;
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

bool IsUnclipped(const Scene& scene, const Profile& profile) {
  if (!profile.no_clip) return true;
  if (scene.clip_space) return false;  // the rectangle is of window space
  const auto holds = [&](const Scene& placed) {
    return std::ranges::all_of(placed.triangles, [&](const Triangle& t) {
      return std::ranges::all_of(
          Corners(placed, t), [&](const Vertex& v) { return profile.no_clip->Contains(v.x, v.y); });
    });
  };
  // Whether clipping looks at a vertex before or after snapping is left to the subject.
  Profile unsnapped = profile;
  unsnapped.snap = {};
  unsnapped.targets.clear();
  return holds(SnapScene(scene, profile)) && holds(SnapScene(scene, unsnapped));
}

}  // namespace rasterproof
