// The description of a subject.
#ifndef RASTERPROOF_CORE_SUBJECT_INFO_H_
#define RASTERPROOF_CORE_SUBJECT_INFO_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// The form in which a subject returns its coverage.
enum class CoverageKind : std::uint8_t {
  kFacingCounts,  ///< how many triangles of each facing cover the sample
  kCounts,        ///< how many triangles cover the sample, all of them in `front`
  kMask,          ///< 1 in `front` where anything covers the sample
  kPrimitiveIds,  ///< which triangle won the sample
  kFragments      ///< the visible triangle, its barycentrics and its depth
};

/// Which of several triangles on a sample wins it.
enum class Visible : std::uint8_t { kLastDrawn, kFirstDrawn };

/// The vertices that a subject's barycentrics belong to: as given, or on the profile's subpixel
/// grid. kEither: it does not say, and may choose differently for each triangle.
enum class BarycentricsOf : std::uint8_t { kEither, kSnapped, kGiven };

/// A subject's statements about the fragments that it shows.
struct FragmentInfo {
  Visible visible = Visible::kLastDrawn;
  BarycentricsOf barycentrics_of = BarycentricsOf::kEither;
  /// Largest absolute error of a barycentric. 0: none is stated.
  double barycentric_error = 0;
  /// Largest absolute error of a depth, in the unit of z. 0: none is stated.
  double depth_error = 0;
  /// Whether it shows barycentrics at centroids too, with the same largest error.
  bool shows_centroids = false;
  /// Whether it shows the values of a scene's channels, and their derivatives.
  bool shows_values = false;
  bool shows_derivatives = false;
};

/// A subject's statements about the edge values that it shows.
struct EdgeInfo {
  bool shows_values = false;
  bool shows_steps = false;
  /// Largest error of a value of E(a, b; p), in units of u times the size of its two products,
  /// |(p.x - a.x)(b.y - a.y)| + |(p.y - a.y)(b.x - a.x)|. 0: exact. Nothing: none is stated.
  std::optional<double> value_error;
  /// Largest error of a value after n steps, in units of (n + 1) u times the larger of these sizes
  /// at the two ends.
  std::optional<double> stepping_error;

  friend bool operator==(const EdgeInfo&, const EdgeInfo&) = default;
};

/// A statement about a method's arithmetic, with the script that proves it.
struct Proof {
  std::string statement;
  std::string script;  ///< in reference/proofs/, run by the tests

  friend bool operator==(const Proof&, const Proof&) = default;
};

/// Leading triangles of the longest list that a subject is given, unless it is asked for another:
/// more than 16 bits number, or than 8 bits where a program reads each as text in its own time.
inline constexpr std::size_t kUsualListLength = (std::size_t{1} << 16) + 1;
inline constexpr std::size_t kListLengthOfPrograms = (std::size_t{1} << 8) + 1;

/// The description of a subject: its profile, the scenes it takes and the outputs it shows.
struct SubjectInfo {
  std::string name;  ///< the one that commands take; for plugins and programs a path
  std::string summary;
  /// The profile that its coverage is judged by.
  Profile profile;
  /// The number format of its input: a float32 subject does not take a float64 scene.
  Precision input = Precision::kFloat32;
  bool takes_window = true;
  bool takes_clip = false;
  /// True if DrawOptions::threads is obeyed: then equal coverage from any number is a property.
  bool takes_threads = false;
  /// True if DrawOptions::float_mode is set around its draws: not of a program, whose mode is its
  /// own.
  bool takes_float_modes = true;
  /// Whether the other members of DrawOptions are obeyed.
  bool takes_tiles = true;
  bool takes_scissor = true;
  bool takes_culling = true;
  CoverageKind coverage = CoverageKind::kFacingCounts;
  /// True if it draws several scenes in one call.
  bool takes_batches = false;
  /// True if DrawJob::repeats is obeyed.
  bool takes_repeats = false;
  /// Leading triangles of the longest list that it is given (LongListDrawsLikeItsEnd).
  std::size_t list_length = kUsualListLength;
  /// True if another processor draws: this machine's processor time then does not include it.
  bool draws_elsewhere = false;
  /// Words of a request on a pipe that it reads (subjects/process/protocol.h).
  bool takes_same = false;
  bool takes_wants = false;
  bool takes_npy = false;
  /// For the kinds kPrimitiveIds and kFragments.
  FragmentInfo fragments;
  /// For subjects that show edge values and state their bounds as numbers.
  EdgeInfo edges;
  /// True if its method states 0 wrong samples against its own profile. Only methods of reference/
  /// and deciders of exact/ set it, never a subject from outside.
  bool states_exact = false;
  /// The proofs about its arithmetic. Only methods of reference/ have any.
  std::vector<Proof> proofs;
  /// The name that a plugin or program gives itself. Empty: none.
  std::string stated_name;
};

/// Returns whether a call reports which triangle won each sample.
inline bool ShowsPrimitiveIds(const SubjectInfo& info) {
  return info.coverage == CoverageKind::kPrimitiveIds || info.coverage == CoverageKind::kFragments;
}

/// Returns whether the subject takes scenes of this kind and precision and, if its input is
/// fixed-point, this scene's coordinates.
inline bool Takes(const SubjectInfo& info, const Scene& scene) {
  if (scene.clip_space ? !info.takes_clip : !info.takes_window) return false;
  if (info.profile.fixed) return CanBeGiven(scene, info.profile);  // as integers
  return info.input == Precision::kFloat64 || scene.precision == Precision::kFloat32;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_INFO_H_
