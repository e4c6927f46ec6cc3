// What a rasterizer promises, as data.
#ifndef RASTERPROOF_CORE_PROFILE_H_
#define RASTERPROOF_CORE_PROFILE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/fill_rule.h"
#include "core/sample_lattice.h"
#include "core/scene.h"
#include "core/snap.h"

namespace rasterproof {

/// Which way y grows in the subject's window space. Rows of a buffer are always stored top row
/// first.
enum class YAxis : std::uint8_t { kDown, kUp };

/// What a subject's coverage can be held to.
enum class Contract : std::uint8_t {
  kSampleExact,  ///< equal to the canonical model's at every sample
  kWatertight,   ///< every sample of an embedded mesh covered exactly once
  kNone          ///< observed, never judged
};

/// The promises of a rasterizer. A result is legal if this model explains all of it.
///
/// Not finite: a triangle with a NaN or infinite x, y or w covers nothing (z is free).
/// Zero area:  a triangle whose area is zero after snapping covers nothing.
struct Profile {
  std::string name = "real";
  Snap snap;
  SampleLattice lattice;
  YAxis y_axis = YAxis::kDown;
  FillRule fill_rule;
  Contract contract = Contract::kSampleExact;
  /// Coordinates beyond +-limit are outside what is promised. Binds verdicts, never the oracle.
  double coordinate_limit = 0x1p127;

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Presets: "real" (no snap), "d3d11", "vulkan", "gl" (8 subpixel bits, nearest-even, top-left).
std::optional<Profile> PresetProfile(std::string_view name);
inline constexpr std::array<std::string_view, 4> kPresetProfiles{"real", "d3d11", "vulkan", "gl"};

/// Returns the scene with x and y of every vertex on the profile's subpixel grid.
///
/// Domain:     window-space scenes; w is 1. (Clip-space vertices snap after the division: see
/// exact/.)
Scene SnapScene(const Scene& scene, const Profile& profile);

/// Returns whether every coordinate of the scene is finite and within the profile's limit.
bool WithinLimits(const Scene& scene, const Profile& profile);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_PROFILE_H_
