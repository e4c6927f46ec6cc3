#include "core/profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/profile_keys.h"
#include "core/square_presets.h"

namespace rasterproof {

namespace {

constexpr std::string_view kCanonical = "-canonical";

// The model that three APIs agree on. Limits: D3D11's guard band, Vulkan's and GL's smallest
// guaranteed viewport bounds range.
Profile CanonicalModel() {
  Profile profile;
  profile.snap = {8, SnapRule::kNearestEven};
  profile.coordinate_limit = 0x1p15;
  profile.infinite_vertex = InfiniteVertex::kUnspecified;
  return profile;
}

// Direct3D 11.3 functional specification: 3.2.4.1 (within 0.6 of a step of the exact value),
// 3.4.2.1 (top-left), 15.4 and 15.16.1 (a NaN in x, y or z discards, infinities may be clamped).
Profile Direct3D11() {
  Profile profile = CanonicalModel();
  profile.freedom.snap_tolerance = 0.6;
  profile.coordinate_limit = 0x1p15 - 0x1p-8;  // 16.8: the upper end of its range
  profile.front_face = FrontFace::kUnstated;
  profile.guard_band = SomewhereAroundTarget{};
  profile.freedom.transform_error.reset();
  profile.nan_z = NanZ::kNothing;
  profile.centroid = Centroid::kDirect3D;
  return profile;
}

// Vulkan's text names neither a rounding nor the owner of a sample on a common edge; four subpixel
// bits are the fewest. It does not mention triangles that are not finite or have no area. Here and
// in the other two, divide and viewport are formulas without an error, the front side is pipeline
// state, and the centroid lies in the pixel and in the primitive.
Profile Vulkan() {
  Profile profile = CanonicalModel();
  profile.freedom = {.any_rounding = true,
                     .least_bits = 4,
                     .ties = TieOwnership::kPerEdge,
                     .transform_error = std::nullopt};
  profile.front_face = FrontFace::kUnstated;
  profile.guard_band = SomewhereAroundTarget{};
  profile.nan_vertex = NanVertex::kUnspecified;
  profile.nan_z = NanZ::kUnspecified;
  profile.centroid = Centroid::kInside;
  profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  return profile;
}

// As Vulkan, and invariant under translation by whole pixels (OpenGL 4.6 section 14.2).
Profile OpenGl() {
  Profile profile = Vulkan();
  profile.translation_invariant = true;
  return profile;
}

// WebGPU 23.2.5.4: "If a pixel center is on the edge of the polygon, whether or not it's included
// is not defined". No number of subpixel bits is stated.
Profile WebGpu() {
  Profile profile = Vulkan();
  profile.freedom.least_bits = 0;
  profile.freedom.ties = TieOwnership::kOpen;
  return profile;
}

std::optional<Profile> OneSamplePreset(std::string_view name) {
  std::optional<Profile> profile;
  if (name == "real") profile = Profile{};
  if (IsCanonicalPreset(name)) profile = CanonicalModel();
  if (name == "d3d11") profile = Direct3D11();
  if (name == "vulkan") profile = Vulkan();
  if (name == "gl") profile = OpenGl();
  if (name == "webgpu") profile = WebGpu();
  return profile;
}

// The set's samples, and where they lie as far as the API says: Direct3D 11.3 19.2.4 and WebGPU
// 23.2.5 have tables; Vulkan has one where standardSampleLocations is true, else positions "may
// differ" by pixel; OpenGL has none, and 14.2 relaxes its invariance for multisampling.
Profile WithSamples(Profile profile, std::string_view api, SamplePattern pattern) {
  profile.pattern = std::move(pattern);
  if (api != "vulkan" && api != "gl") return profile;
  profile.sample_positions = SamplePositions::kVary;
  profile.translation_invariant = false;
  return profile;
}

std::optional<Profile> MultisampledPreset(std::string_view name) {
  for (const int samples : {2, 4, 8, 16}) {
    const std::string ending = "-" + std::to_string(samples) + "x";
    if (!name.ends_with(ending)) continue;
    const std::string_view api = name.substr(0, name.size() - ending.size());
    const std::optional<Profile> one = OneSamplePreset(api == "vulkan-standard" ? "vulkan" : api);
    if (one) return WithSamples(*one, api, *StandardPattern(samples));
  }
  return std::nullopt;
}

// Copies the keys that `is_copied` is true of.
template <class IsCopied>
void CopyKeys(const Profile& from, Profile& to, IsCopied is_copied) {
  for (const ProfileKey& key : kProfileKeys) {
    if (is_copied(key)) key.member.copy(from, to);
  }
}

}  // namespace

std::optional<Profile> PresetProfile(std::string_view name) {
  std::optional<Profile> profile = OneSamplePreset(name);
  if (!profile) profile = MultisampledPreset(name);
  if (!profile) return SquarePreset(name);
  if (profile) profile->name = name;
  return profile;
}

bool IsCanonicalPreset(std::string_view name) {
  return name.ends_with(kCanonical) &&
         std::ranges::find(kPresetProfiles, name) != kPresetProfiles.end();
}

Profile FilledIn(const Profile& set, const Profile& device) {
  Profile filled = set;
  CopyKeys(device, filled, [](const ProfileKey& key) { return (key.marks & kOfDevice) != 0; });
  if (set.freedom.least_bits && !device.snap.IsNone()) {
    filled.snap.bits = device.snap.bits;
    filled.freedom.least_bits = device.freedom.least_bits;
  }
  return filled;
}

bool IsFilledIn(const Profile& profile) {
  const std::optional<Profile> set = PresetProfile(profile.specification);
  if (!set) return false;
  Profile filled = FilledIn(*set, profile);
  CopyKeys(profile, filled, [](const ProfileKey& key) { return key.kind == KeyKind::kName; });
  const int least = set->freedom.least_bits.value_or(0);
  return filled == profile && profile.freedom.least_bits.value_or(profile.snap.bits) >= least;
}

bool SameModel(const Profile& a, const Profile& b) {
  Profile judged_alike = a;
  CopyKeys(b, judged_alike, [](const ProfileKey& key) { return key.kind != KeyKind::kModel; });
  return judged_alike == b;
}

std::optional<WindowBox> UnclippedBox(const Profile& profile, int width, int height) {
  if (!profile.guard_band) return std::nullopt;
  if (const auto* box = std::get_if<WindowBox>(&*profile.guard_band)) return *box;
  const auto* around = std::get_if<AroundTarget>(&*profile.guard_band);
  const double pixels = around != nullptr ? around->pixels : 0;
  return WindowBox{-pixels, -pixels, width + pixels, height + pixels};
}

namespace {

// The product may round; a position within an ulp of the limit is not worth judging.
bool ProjectsBeyond(const Scene& scene, double limit) {
  return std::ranges::any_of(scene.vertices, [&](const Vertex& v) {
    const double reach = limit * v.w;
    return IsFinite(v) && (std::fabs(v.x) > reach || std::fabs(v.y) > reach);
  });
}

}  // namespace

std::optional<std::string> WhyTooLarge(const Scene& scene, const Profile& profile) {
  if (!profile.max_target.Holds(scene.width, scene.height))
    return "the target is larger than the profile's max_target";
  return std::nullopt;
}

std::optional<std::string> WhyBeyondLimits(const Scene& scene, const Profile& profile) {
  if (auto why = WhyTooLarge(scene, profile)) return why;
  if (!CanBeGiven(scene, profile))
    return "the profile's fixed-point input does not take a coordinate of the scene";
  const auto is_beyond = [&](const Vertex& v) {
    return IsFinite(v) && std::max(std::fabs(v.x), std::fabs(v.y)) > profile.coordinate_limit;
  };
  if (std::ranges::any_of(scene.vertices, is_beyond))
    return "a coordinate lies beyond the profile's coordinate_limit";
  if (scene.clip_space && !profile.snap.IsNone() && ProjectsBeyond(scene, profile.coordinate_limit))
    return "a vertex projects beyond the profile's coordinate_limit";
  return std::nullopt;
}

std::optional<std::string> WhyNotWithinLimits(const Scene& scene, const Profile& profile) {
  const auto is_stated = [&](const Vertex& v) {
    return IsFinite(v) && (profile.nan_z == NanZ::kIgnored || !std::isnan(v.z));
  };
  if (!std::ranges::all_of(scene.vertices, is_stated)) return "a coordinate is not finite";
  return WhyBeyondLimits(scene, profile);
}

bool WithinLimits(const Scene& scene, const Profile& profile) {
  return !WhyNotWithinLimits(scene, profile);
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
