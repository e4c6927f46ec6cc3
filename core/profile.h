// The statements of a rasterizer about itself, as data.
#ifndef RASTERPROOF_CORE_PROFILE_H_
#define RASTERPROOF_CORE_PROFILE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/draw_options.h"
#include "core/fixed_input.h"
#include "core/freedom.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "core/snap.h"
#include "core/square_rule.h"
#include "core/tie_rule.h"
#include "core/transform.h"
#include "core/value_rule.h"

namespace rasterproof {

/// Which way y grows in the subject's window space. Rows of a buffer are always stored top row
/// first.
enum class YAxis : std::uint8_t { kDown, kUp };

/// Which side of a triangle is its front.
enum class FrontFace : std::uint8_t {
  kPositiveArea,  ///< the side of positive area, as in CoverageCounts
  kUnstated       ///< either side, the same for all triangles of all calls: pipeline state
};

/// The requirement on a subject's coverage.
enum class Contract : std::uint8_t {
  kSampleExact,   ///< equal to the model's at every sample
  kWatertight,    ///< every sample of an embedded mesh covered exactly once
  kClosed,        ///< front minus back is zero wherever a closed surface is drawn
  kAtLeastModel,  ///< each triangle covers at least the samples that the model covers
  kAtMostModel,   ///< each triangle covers at most the samples that the model covers
  kSquares,       ///< whole pixels, as `squares` states
  kNone           ///< coverage is observed, never judged
};

/// The statement about a triangle that has no area after snapping.
enum class DegenerateTriangles : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover samples on its closed edges, each or none
};

/// The statement about a triangle with an infinite x, y or w.
enum class InfiniteVertex : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: not judged
};

/// The statement about a triangle with a NaN in x, y or w.
enum class NanVertex : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: not judged
};

/// The statement about a triangle with a NaN in z alone.
enum class NanZ : std::uint8_t {
  kIgnored,     ///< it covers what it would with any other z
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: not judged
};

/// The largest triangle that is drawn, in pixels: a wider or higher one covers nothing.
struct MaxPrimitiveExtent {
  double width = 0;
  double height = 0;

  friend bool operator==(const MaxPrimitiveExtent&, const MaxPrimitiveExtent&) = default;
};

/// The largest target that a rasterizer takes, in pixels.
struct LargestTarget {
  int width = kMaxTargetSide;
  int height = kMaxTargetSide;

  bool Holds(int w, int h) const { return w <= width && h <= height; }
  friend bool operator==(const LargestTarget&, const LargestTarget&) = default;
};

/// A rectangle of window coordinates, its sides included.
struct WindowBox {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;

  bool Contains(double x, double y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
  friend bool operator==(const WindowBox&, const WindowBox&) = default;
};

/// The target and a margin around it.
struct AroundTarget {
  double pixels = 0;  ///< width of the margin, an integer

  friend bool operator==(const AroundTarget&, const AroundTarget&) = default;
};

/// An unknown rectangle that holds the target.
struct SomewhereAroundTarget {
  friend bool operator==(const SomewhereAroundTarget&, const SomewhereAroundTarget&) = default;
};

/// Where triangles are clipped.
using GuardBand = std::variant<WindowBox, AroundTarget, SomewhereAroundTarget>;

/// The keys that differ on targets of at most the given size.
struct TargetModel {
  int max_width = kMaxTargetSide;
  int max_height = kMaxTargetSide;
  Snap snap = {};
  SamplePattern pattern = {};  ///< as many locations as the profile's own
  TieRule tie_rule = {};

  bool Fits(int width, int height) const { return width <= max_width && height <= max_height; }
  friend bool operator==(const TargetModel&, const TargetModel&) = default;
};

/// The contracts of a rasterizer.
///
/// A profile denotes a set of models: the canonical one that its members state and, with freedom,
/// one for every choice that the freedom allows of a grid, of a grid point for every vertex and of
/// owners of samples on edges. A result is legal if a single model explains all of it.
///
/// Not finite: a triangle with a NaN or infinite x, y or w covers nothing, unless `nan_vertex` or
///             `infinite_vertex` says otherwise; z is free, unless `nan_z` says otherwise.
/// Zero area:  a triangle whose area is zero after snapping covers nothing, unless
///             `degenerate_triangles` says otherwise.
/// The order:  a coordinate is wrapped (`fixed`), then snapped; then triangles larger than
///             `max_primitive_extent` are dropped, and those that face as `culls` says.
/// Window space alone: `fixed`, `scanline_rounding`, `max_primitive_extent`, `guard_band` and
///             `squares` say nothing about clip space.
struct Profile {
  std::string name = "real";
  /// The preset, "vulkan", if the profile is its legal set with the numbers of one device. See
  /// FilledIn. Empty: `name` says which preset this is, if any.
  std::string specification;
  Snap snap;
  /// Where an edge crosses a row of samples, x is rounded to this grid before samples are compared
  /// with it, as scanline rasterizers do. None: the crossing is not rounded. A sample at a rounded
  /// crossing is owned like a sample on a vertical edge.
  Snap scanline_rounding;
  SamplePattern pattern;
  /// Whether samples lie where `pattern` says. Where they need not, singles are not judged, while
  /// meshes are: whatever a sample's place, a shared edge gives it to one side.
  SamplePositions sample_positions = SamplePositions::kStated;
  /// The place where attributes requested at a fragment's centroid are evaluated.
  Centroid centroid = Centroid::kUnstated;
  YAxis y_axis = YAxis::kDown;
  TieRule tie_rule;
  /// Domain:     kUnstated only with freedom: one model has one front.
  FrontFace front_face = FrontFace::kPositiveArea;
  /// The side that is never drawn, whatever a draw asks for: a triangle that shows it covers
  /// nothing. A draw that culls the other side leaves nothing.
  /// Domain:     kNone if `front_face` is unstated.
  Cull culls = Cull::kNone;
  Contract contract = Contract::kSampleExact;
  Freedom freedom;
  /// The transform from clip space, or from a map, to window space that the rasterizer computes
  /// itself. None: clip space is held to its exact quotients.
  std::optional<Transform> transform;
  /// Nothing is stated of coordinates beyond +-limit. Binds verdicts, never the oracle.
  double coordinate_limit = 0x1p127;
  DegenerateTriangles degenerate_triangles = DegenerateTriangles::kNothing;
  InfiniteVertex infinite_vertex = InfiniteVertex::kNothing;
  NanVertex nan_vertex = NanVertex::kNothing;
  NanZ nan_z = NanZ::kIgnored;
  /// Whether it is stated that a scene moved by whole pixels covers the moved samples, whatever the
  /// freedom. (One model on a grid always does so.)
  bool translation_invariant = false;
  /// A sample on an edge belongs to the triangle that the tie rule names, and may also belong to
  /// the other triangles with that edge. Meshes are then covered at least once.
  bool shares_edge_samples = false;
  /// Models of smaller targets. The first entry that fits a target holds there, else what the
  /// profile itself says. See TargetProfile.
  std::vector<TargetModel> by_target_size;
  /// The integer format of coordinates, for a subject that takes no floats.
  std::optional<FixedInput> fixed;
  std::optional<MaxPrimitiveExtent> max_primitive_extent;
  /// Nothing is stated of larger targets, whose coordinates its registers need not hold.
  LargestTarget max_target;
  /// The subject may clip a triangle with a vertex outside, and its edges that leave may move: then
  /// meshes are judged, single samples are not. None: nothing is clipped. Where grid points are
  /// left free, so are those of vertices that clipping makes: see MovesClippedEdges.
  std::optional<GuardBand> guard_band;

  /// The statement of the contract `squares` about whole pixels. Nothing: samples are points.
  std::optional<SquareRule> squares;
  ValueRule values;  ///< the statement about what a covered sample holds

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Presets.
///
/// "real" (no snap), "d3d11-canonical", "vulkan-canonical" and "gl-canonical" (8 subpixel bits,
/// nearest-even, top-left) name models. "d3d11", "vulkan", "gl" and "webgpu" name legal sets, which
/// leave open what the specification leaves open. io/profile_json.h lists all, those of
/// several samples ("gl-4x") and of whole pixels ("voxel") too.
///
/// Each name can end with "-2x", "-4x", "-8x" or "-16x", the number of samples in a pixel.
/// Where the API's text leaves their positions open ("vulkan" without standardSampleLocations,
/// "gl"), so does the set; "vulkan-standard-4x" is Vulkan's where that limit is true.
std::optional<Profile> PresetProfile(std::string_view name);
inline constexpr std::array<std::string_view, 8> kPresetProfiles{
    "real", "d3d11-canonical", "vulkan-canonical", "gl-canonical", "d3d11", "vulkan",
    "gl",   "webgpu"};

/// Returns whether the preset is the canonical model of an API that also allows others: a legal
/// rasterizer may then differ from it.
bool IsCanonicalPreset(std::string_view name);

/// Returns the legal set with the device's sample locations, coordinate limit, guard band and front
/// face, and with its subpixel bits where the set leaves those to the device.
Profile FilledIn(const Profile& set, const Profile& device);

/// Returns whether the profile is its specification's legal set with the numbers of a device that
/// the set allows: its grid has no fewer bits than the least. False if it names no specification.
bool IsFilledIn(const Profile& profile);

/// Returns whether the profile's transform takes the scene to the window: a transform of clip space
/// takes scenes in clip space, a transform of a map takes all others.
inline bool TakesToWindow(const Profile& profile, const Scene& scene) {
  return profile.transform && scene.clip_space != profile.transform->map.has_value();
}

/// Returns whether the profile's model of the scene works in homogeneous coordinates: clip space
/// that the rasterizer does not itself take to the window.
inline bool IsHomogeneous(const Scene& scene, const Profile& profile) {
  return scene.clip_space && !TakesToWindow(profile, scene);
}

/// Returns the largest rectangle of window coordinates, on a target of that size, within which the
/// profile states that nothing is clipped. Nothing: no triangle is clipped, wherever it lies.
std::optional<WindowBox> UnclippedBox(const Profile& profile, int width, int height);

/// Returns whether the profile says to which rectangle triangles are clipped.
inline bool StatesGuardBand(const Profile& profile) {
  return profile.guard_band && !std::holds_alternative<SomewhereAroundTarget>(*profile.guard_band);
}

/// Returns whether the samples next to an edge that leaves the guard band are open, separately for
/// each of the edge's triangles: clipping makes a vertex there, the profile leaves its grid point
/// free, and neighbours need not choose the same one.
inline bool MovesClippedEdges(const Profile& profile) {
  return profile.guard_band && profile.contract == Contract::kSampleExact &&
         profile.freedom.MovesVertices();
}

/// Returns whether the profile never draws a triangle of this facing on screen: +1 front, -1 back.
inline bool AlwaysCulls(const Profile& profile, int facing) {
  return (profile.culls == Cull::kFront && facing > 0) ||
         (profile.culls == Cull::kBack && facing < 0);
}

/// Returns whether the profile leaves nothing open: of every scene within its limits that it places
/// exactly one result is legal.
inline bool HasOneModel(const Profile& profile) {
  return profile.contract == Contract::kSampleExact && profile.freedom.IsNone() &&
         !profile.shares_edge_samples && profile.sample_positions == SamplePositions::kStated;
}

/// Returns whether the canonical models of two profiles are equal: whether they give every scene
/// the same counts. Names, contracts, freedom and limits may differ.
bool SameModel(const Profile& a, const Profile& b);

/// Returns which limit of sizes the scene exceeds, as a clause that names its key. Nothing if none.
std::optional<std::string> WhyTooLarge(const Scene& scene, const Profile& profile);

/// Returns which limit of the profile the scene exceeds, as a clause that names its key: the target
/// is too large, the fixed-point input does not take a coordinate, or x or y of a finite vertex
/// lies too far out or, of clip space on a grid, projects too far. Nothing if none: what is not
/// finite has keys of its own.
///
/// Whoever judges a scene or searches its legal models asks here. Domains and properties that
/// choose sizes or coordinates of their own choose them by the keys.
std::optional<std::string> WhyBeyondLimits(const Scene& scene, const Profile& profile);

/// Returns whether the scene lies within the profile's limits and is finite: x, y and w are, and z
/// is no NaN unless one changes nothing there (NanZ::kIgnored).
bool WithinLimits(const Scene& scene, const Profile& profile);

/// Returns why not, as WhyBeyondLimits does; nothing if it is.
std::optional<std::string> WhyNotWithinLimits(const Scene& scene, const Profile& profile);

/// Returns whether a subject of this profile can be given the scene at all: a fixed-point input
/// takes only window space, and only coordinates that its integers hold.
bool CanBeGiven(const Scene& scene, const Profile& profile);

/// Returns whether the profile's placing of vertices is defined for clip space.
inline bool PlacesClipSpace(const Profile& profile) {
  return !profile.fixed && !profile.max_primitive_extent && profile.scanline_rounding.IsNone();
}

/// Returns whether no coordinate is beyond the range of the profile's fixed-point input: then
/// nothing wraps, and moving a scene moves all of it.
bool IsUnwrapped(const Scene& scene, const Profile& profile);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_PROFILE_H_
