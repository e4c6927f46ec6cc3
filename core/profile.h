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
#include "core/transform.h"

namespace rasterproof {

/// Which way y grows in the subject's window space. Rows of a buffer are always stored top row
/// first.
enum class YAxis : std::uint8_t { kDown, kUp };

/// What a subject's coverage can be held to.
enum class Contract : std::uint8_t {
  kSampleExact,        ///< equal to the model's at every sample
  kWatertight,         ///< every sample of an embedded mesh covered exactly once
  kClosed,             ///< front minus back is zero wherever a closed surface is drawn
  kConservativeOver,   ///< each triangle covers at least the samples that the model covers
  kConservativeUnder,  ///< each triangle covers at most the samples that the model covers
  kNone                ///< observed, never judged
};

/// What a profile leaves to the rasterizer. Nothing, unless it is said.
struct Freedom {
  /// A vertex may take any grid point within so many steps of the grid, on each axis (D3D: 0.6).
  /// 0: the one that the snap rule names.
  double snap_tolerance = 0;
  /// Any of the eight consistent tie rules will do, the same one everywhere.
  bool any_tie_rule = false;

  bool IsNone() const { return snap_tolerance == 0 && !any_tie_rule; }
  friend bool operator==(const Freedom&, const Freedom&) = default;
};

/// At most this many steps of tolerance: a coordinate then has two grid points to choose from, or
/// three if it is one.
inline constexpr double kMaxSnapTolerance = 1;

/// The promises of a rasterizer.
///
/// A profile denotes a set of models: the canonical one that its members state, and with freedom
/// every choice of grid points (one for every vertex) and tie rule (one for all) that the freedom
/// allows. A result is legal if one of them explains all of it.
///
/// Not finite: a triangle with a NaN or infinite x, y or w covers nothing (z is free).
/// Zero area:  a triangle whose area is zero after snapping covers nothing.
struct Profile {
  std::string name = "real";
  Snap snap;
  /// Where an edge crosses a row of samples, x is rounded to this grid before samples are compared
  /// with it, as scanline rasterizers do. None: the crossing is the real one. A sample at a rounded
  /// crossing is owned as one on a vertical edge.
  Snap crossing;
  SampleLattice lattice;
  YAxis y_axis = YAxis::kDown;
  FillRule fill_rule;
  Contract contract = Contract::kSampleExact;
  Freedom freedom;
  /// The way from clip space to window space that the rasterizer computes itself. None: clip space is
  /// held to its exact quotients.
  std::optional<Transform> transform;
  /// Coordinates beyond +-limit are outside what is promised. Binds verdicts, never the oracle.
  double coordinate_limit = 0x1p127;

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Presets: "real" (no snap), "d3d11", "vulkan", "gl" (8 subpixel bits, nearest-even, top-left).
/// They are the canonical models: what each API leaves free (docs/decisions/0070) is not in them.
std::optional<Profile> PresetProfile(std::string_view name);
inline constexpr std::array<std::string_view, 4> kPresetProfiles{"real", "d3d11", "vulkan", "gl"};

/// Returns whether the profile's model of the scene is that of homogeneous coordinates: clip space
/// that no transform of the rasterizer's own takes to the window.
inline bool IsHomogeneous(const Scene& scene, const Profile& profile) {
  return scene.clip_space && !profile.transform;
}

/// Returns the scene with x and y of every vertex on the profile's subpixel grid.
///
/// Domain:     window-space scenes; w is 1. Clip-space scenes that are not homogeneous: they go
///             through the profile's transform first. (Others snap after the division: see exact/.)
Scene SnapScene(const Scene& scene, const Profile& profile);

/// Returns whether exactly one result is legal for every scene within the limits.
inline bool HasOneModel(const Profile& profile) {
  return profile.contract == Contract::kSampleExact && profile.freedom.IsNone();
}

/// Returns whether every coordinate of the scene is finite and within the profile's limit.
bool WithinLimits(const Scene& scene, const Profile& profile);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_PROFILE_H_
