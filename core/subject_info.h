// What a subject says of itself.
#ifndef RASTERPROOF_CORE_SUBJECT_INFO_H_
#define RASTERPROOF_CORE_SUBJECT_INFO_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// What a subject's coverage comes back as.
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
/// grid. kEither: it does not say, and may take the ones for one triangle and the others for the
/// next.
enum class BarycentricsOf : std::uint8_t { kEither, kSnapped, kGiven };

/// What a subject says of the fragments that it shows.
struct FragmentInfo {
  Visible visible = Visible::kLastDrawn;
  BarycentricsOf barycentrics_of = BarycentricsOf::kEither;
  /// Most that a barycentric is off, absolute. 0: it says nothing.
  double barycentric_error = 0;
  /// Most that a depth is off, absolute, in the unit of z. 0: it says nothing.
  double depth_error = 0;
  /// Whether it shows barycentrics at centroids too, off by as much as the others.
  bool shows_centroids = false;
};

/// What a subject says of the edge values that it shows, in one number each.
struct EdgeInfo {
  bool shows_values = false;
  bool shows_steps = false;
  /// A value of E(a, b; p) is off by at most so many u of the size of its two products,
  /// |(p.x - a.x)(b.y - a.y)| + |(p.y - a.y)(b.x - a.x)|. 0: exact. Nothing: nothing is said.
  std::optional<double> value_error;
  /// After n steps a value is off by at most (n + 1) times so many u of the larger size at its two
  /// ends.
  std::optional<double> stepping_error;

  friend bool operator==(const EdgeInfo&, const EdgeInfo&) = default;
};

/// A statement about a method's arithmetic that a script proves.
struct Proof {
  std::string statement;
  std::string script;  ///< in reference/proofs/, run by the tests

  friend bool operator==(const Proof&, const Proof&) = default;
};

/// What a subject says of itself.
struct SubjectInfo {
  std::string name;
  std::string summary;
  /// What its coverage is held to.
  Profile profile;
  /// The number format it computes its input in: a float64 scene is no input for a float32 subject.
  Precision input = Precision::kFloat32;
  bool takes_window = true;
  bool takes_clip = false;
  /// True if DrawOptions::threads is more than a wish: then equal coverage from any number is a
  /// property.
  bool takes_threads = false;
  /// Whether the other members of DrawOptions are obeyed.
  bool takes_tiles = true;
  bool takes_scissor = true;
  bool takes_culling = true;
  CoverageKind coverage = CoverageKind::kFacingCounts;
  /// True if it draws several scenes in one call.
  bool takes_batches = false;
  /// True if DrawJob::repeats is obeyed.
  bool takes_repeats = false;
  /// True if another processor draws, which this machine's processor time says nothing of.
  bool draws_elsewhere = false;
  /// The version of the protocol that it speaks, on a pipe (subjects/process/protocol.h).
  int protocol = 1;
  /// For the kinds kPrimitiveIds and kFragments.
  FragmentInfo fragments;
  /// For subjects that show edge values and state their bounds as numbers.
  EdgeInfo edges;
  /// True if its method states 0 wrong samples against its own profile. Methods of reference/ and
  /// deciders of exact/ alone; nothing that comes from outside sets it.
  bool states_exact = false;
  /// What is proved of its arithmetic. Methods of reference/ alone.
  std::vector<Proof> proofs;
};

/// Returns whether a call tells which triangle won each sample.
inline bool ShowsPrimitiveIds(const SubjectInfo& info) {
  return info.coverage == CoverageKind::kPrimitiveIds || info.coverage == CoverageKind::kFragments;
}

/// Returns whether the subject takes scenes of this kind and precision, and coordinates that its
/// fixed-point input can be given.
inline bool Takes(const SubjectInfo& info, const Scene& scene) {
  if (scene.clip_space ? !info.takes_clip : !info.takes_window) return false;
  if (info.profile.fixed) return CanBeGiven(scene, info.profile);  // as integers
  return info.input == Precision::kFloat64 || scene.precision == Precision::kFloat32;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_INFO_H_
