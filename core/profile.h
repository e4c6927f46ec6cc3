// What a rasterizer states, as data.
#ifndef RASTERPROOF_CORE_PROFILE_H_
#define RASTERPROOF_CORE_PROFILE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/fixed_input.h"
#include "core/freedom.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "core/snap.h"
#include "core/square_rule.h"
#include "core/tie_rule.h"
#include "core/transform.h"

namespace rasterproof {

/// Which way y grows in the subject's window space. Rows of a buffer are always stored top row
/// first.
enum class YAxis : std::uint8_t { kDown, kUp };

/// Which side of a triangle is its front.
enum class FrontFace : std::uint8_t {
  kPositiveArea,  ///< the one of positive area, as CoverageCounts has it
  kUnstated       ///< either, one for all triangles of all calls: it is state of the pipeline
};

/// What a subject's coverage can be held to.
enum class Contract : std::uint8_t {
  kSampleExact,   ///< equal to the model's at every sample
  kWatertight,    ///< every sample of an embedded mesh covered exactly once
  kClosed,        ///< front minus back is zero wherever a closed surface is drawn
  kAtLeastModel,  ///< each triangle covers at least the samples that the model covers
  kAtMostModel,   ///< each triangle covers at most the samples that the model covers
  kSquares,       ///< what `squares` states of whole pixels
  kNone           ///< observed, never judged
};

/// What is stated of a triangle that has no area after snapping.
enum class DegenerateTriangles : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover something: it is left out of what is judged
};

/// What is stated of a triangle with an infinite x, y or w.
enum class InfiniteVertex : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: what it covers is not judged
};

/// What is stated of a triangle with a NaN in x, y or w.
enum class NanVertex : std::uint8_t {
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: what it covers is not judged
};

/// What is stated of a triangle with a NaN in z alone.
enum class NanZ : std::uint8_t {
  kIgnored,     ///< it covers what it would with any other z
  kNothing,     ///< it covers nothing
  kUnspecified  ///< it may cover anything: what it covers is not judged
};

/// The largest triangle that is drawn, in pixels: one that is wider or higher covers nothing.
struct MaxPrimitiveExtent {
  double width = 0;
  double height = 0;

  friend bool operator==(const MaxPrimitiveExtent&, const MaxPrimitiveExtent&) = default;
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

/// The target, and so many pixels around it.
struct AroundTarget {
  double pixels = 0;  ///< whole

  friend bool operator==(const AroundTarget&, const AroundTarget&) = default;
};

/// A rectangle that is not stated, but that it holds the target.
struct SomewhereAroundTarget {
  friend bool operator==(const SomewhereAroundTarget&, const SomewhereAroundTarget&) = default;
};

/// Where triangles are clipped.
using GuardBand = std::variant<WindowBox, AroundTarget, SomewhereAroundTarget>;

/// What differs on targets of up to so many pixels a side.
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
/// A profile denotes a set of models: the canonical one that its members state, and with freedom
/// every choice of a grid, of grid points (one for every vertex) and of owners of samples on edges
/// that the freedom allows. A result is legal if one of them explains all of it.
///
/// Not finite: a triangle with a NaN or infinite x, y or w covers nothing, unless `nan_vertex` or
///             `infinite_vertex` says otherwise; z is free, unless `nan_z` says otherwise.
/// Zero area:  a triangle whose area is zero after snapping covers nothing, unless
///             `degenerate_triangles` says otherwise.
/// The order:  a coordinate is wrapped (`fixed`), then snapped; then triangles larger than
///             `max_primitive_extent` are dropped.
/// Window space alone: what `fixed`, `scanline_rounding`, `max_primitive_extent`, `guard_band` and
///             `squares` say.
struct Profile {
  std::string name = "real";
  /// The legal set that this is, with numbers of one device, as the preset is named: "vulkan". See
  /// FilledIn. Empty: `name` says which preset this is, if any.
  std::string specification;
  Snap snap;
  /// Where an edge crosses a row of samples, x is rounded to this grid before samples are compared
  /// with it, as scanline rasterizers do. None: the crossing is the real one. A sample at a rounded
  /// crossing is owned as one on a vertical edge.
  Snap scanline_rounding;
  SamplePattern pattern;
  /// Whether samples lie where `pattern` says. Where they need not, singles are not judged, while
  /// meshes are: whatever a sample's place, a shared edge gives it to one side.
  SamplePositions sample_positions = SamplePositions::kStated;
  /// Where attributes are evaluated that are asked for at a fragment's centroid.
  Centroid centroid = Centroid::kUnstated;
  YAxis y_axis = YAxis::kDown;
  TieRule tie_rule;
  /// Domain:     kUnstated only with freedom: one model has one front.
  FrontFace front_face = FrontFace::kPositiveArea;
  Contract contract = Contract::kSampleExact;
  Freedom freedom;
  /// The way from clip space, or from a map, to window space that the rasterizer computes itself.
  /// None: clip space is held to its exact quotients.
  std::optional<Transform> transform;
  /// Coordinates beyond +-limit are outside what is stated. Binds verdicts, never the oracle.
  double coordinate_limit = 0x1p127;
  DegenerateTriangles degenerate_triangles = DegenerateTriangles::kNothing;
  InfiniteVertex infinite_vertex = InfiniteVertex::kNothing;
  NanVertex nan_vertex = NanVertex::kNothing;
  NanZ nan_z = NanZ::kIgnored;
  /// Whether it is stated that a scene moved by whole pixels covers the moved samples, whatever the
  /// freedom. (One model on a grid always does so.)
  bool translation_invariant = false;
  /// A sample on an edge belongs to the triangle that the tie rule names, and may belong to every
  /// other one that has the edge. Meshes are then covered at least once.
  bool shares_edge_samples = false;
  /// Models of smaller targets. The first entry that fits a target holds there, else what the
  /// profile itself says. See TargetProfile.
  std::vector<TargetModel> by_target_size;
  /// The integers that coordinates come as, for a subject that takes no floats.
  std::optional<FixedInput> fixed;
  std::optional<MaxPrimitiveExtent> max_primitive_extent;
  /// A triangle with a vertex outside may be clipped by the subject, and edges that leave may move:
  /// what single samples do is then not stated, what meshes do is. None: nothing is clipped. Where
  /// grid points are left free, the vertices that clipping makes are too: see MovesClippedEdges.
  std::optional<GuardBand> guard_band;

  /// What is stated of pixels as squares, of a contract `squares`. Nothing: samples are points.
  std::optional<SquareRule> squares;

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Presets.
///
/// "real" (no snap), "d3d11-canonical", "vulkan-canonical" and "gl-canonical" (8 subpixel bits,
/// nearest-even, top-left) name models. "d3d11", "vulkan", "gl" and "webgpu" name legal sets: what
/// a sentence of the specification leaves open is left open.
///
/// With 2, 4, 8 or 16 samples a pixel: each name with "-2x", "-4x", "-8x" or "-16x" behind it.
/// Where the API's own text leaves their positions open ("vulkan" without standardSampleLocations,
/// "gl"), so does the set; "vulkan-standard-4x" is Vulkan's where that limit is true.
std::optional<Profile> PresetProfile(std::string_view name);
inline constexpr std::array<std::string_view, 8> kPresetProfiles{
    "real", "d3d11-canonical", "vulkan-canonical", "gl-canonical", "d3d11", "vulkan",
    "gl",   "webgpu"};

/// Returns whether the preset is the canonical model of an API that leaves more than it to the
/// rasterizer: a legal one may then differ from it.
bool IsCanonicalPreset(std::string_view name);

/// Returns the legal set with what is said of one device: sample locations, coordinate limit, guard
/// band, the front face, and where the set leaves the subpixel bits to the device, those.
Profile FilledIn(const Profile& set, const Profile& device);

/// Returns whether the profile is its specification's legal set with the numbers of a device that
/// the set allows: its grid has no fewer bits than the least. False where it names none.
bool IsFilledIn(const Profile& profile);

/// Returns whether the profile's transform takes the scene to the window: a transform of clip space
/// takes clip space, that of a map all else.
inline bool TakesToWindow(const Profile& profile, const Scene& scene) {
  return profile.transform && scene.clip_space != profile.transform->map.has_value();
}

/// Returns whether the profile's model of the scene is that of homogeneous coordinates: clip space
/// that no transform of the rasterizer's own takes to the window.
inline bool IsHomogeneous(const Scene& scene, const Profile& profile) {
  return scene.clip_space && !TakesToWindow(profile, scene);
}

/// Returns the largest rectangle of window coordinates, on a target of that size, within which the
/// profile states that nothing is clipped. Nothing: no triangle is, wherever it lies.
std::optional<WindowBox> UnclippedBox(const Profile& profile, int width, int height);

/// Returns whether the profile says which rectangle clipping is to.
inline bool StatesGuardBand(const Profile& profile) {
  return profile.guard_band && !std::holds_alternative<SomewhereAroundTarget>(*profile.guard_band);
}

/// Returns whether a legal result may have the samples next to an edge that leaves the guard band
/// either way, for each of the edge's triangles: clipping makes a vertex there, which goes to a
/// grid point that the profile leaves free, and which neighbours need not have in common.
inline bool MovesClippedEdges(const Profile& profile) {
  return profile.guard_band && profile.contract == Contract::kSampleExact &&
         profile.freedom.MovesVertices();
}

/// Returns whether exactly one result is legal for every scene within the limits.
inline bool HasOneModel(const Profile& profile) {
  return profile.contract == Contract::kSampleExact && profile.freedom.IsNone() &&
         !profile.shares_edge_samples && profile.sample_positions == SamplePositions::kStated;
}

/// Returns whether the canonical models of two profiles are one: whether they say the same of every
/// scene's counts. What else they state, and how they are named, may differ.
bool SameModel(const Profile& a, const Profile& b);

/// Returns whether every coordinate of the scene is finite, within the profile's limit, and one
/// that its fixed-point input can be given.
bool WithinLimits(const Scene& scene, const Profile& profile);

/// Returns whether a subject of this profile can be given the scene at all: of a fixed-point input,
/// window space alone, and coordinates that its integers hold.
bool CanBeGiven(const Scene& scene, const Profile& profile);

/// Returns whether the profile says where a clip-space scene's vertices lie.
inline bool PlacesClipSpace(const Profile& profile) {
  return !profile.fixed && !profile.max_primitive_extent && profile.scanline_rounding.IsNone();
}

/// Returns whether no coordinate is beyond the range of the profile's fixed-point input: then
/// nothing wraps, and moving a scene moves all of it.
bool IsUnwrapped(const Scene& scene, const Profile& profile);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_PROFILE_H_
