// A rasterizer under test, and what it can be asked.
#ifndef RASTERPROOF_CORE_SUBJECT_H_
#define RASTERPROOF_CORE_SUBJECT_H_

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof {

/// One of the eight walks: along one axis, either way, by one pixel or by `length` pixels at a
/// time.
struct Step {
  bool along_y = false;
  int sign = +1;
  int length = 1;
};

/// What a subject states of its edge values, before any is asked for.
class EdgeBounds {
 public:
  virtual ~EdgeBounds() = default;

  /// A proven bound on |EdgeEvaluator::Value - E|, or NaN where no bound is claimed (overflow,
  /// underflow). 0: exact.
  virtual double ErrorBound(Point2 a, Point2 b, Point2 p) const = 0;
  /// A proven bound on |EdgeEvaluator::Walk(...)[n] - E| for n = 0..steps, or NaN where none is
  /// claimed.
  virtual std::vector<double> WalkErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                              int steps) const = 0;
};

/// Edge values, for subjects that show them.
class EdgeEvaluator : public EdgeBounds {
 public:
  /// The subject's value of E(a, b; p), evaluated afresh at p.
  ///
  /// Units:      pixels squared.
  virtual double Value(Point2 a, Point2 b, Point2 p) const = 0;
  /// The values met when the subject walks `steps` steps from p: steps + 1 entries, the first at p.
  virtual std::vector<double> Walk(Point2 a, Point2 b, Point2 p, Step step, int steps) const = 0;
};

/// The ways to turn edge values into weights.
enum class BarycentricForm : std::uint8_t {
  kVertexArea,   ///< E_i / E(v0, v1; v2)
  kSum,          ///< E_i / fl(E_0 + E_1 + E_2)
  kOneMinus,     ///< l0, l1 over the vertex area, l2 = (1 - l0) - l1
  kUnsignedArea  ///< |area_i| / |area|: only right inside the closed triangle
};

enum class InterpolationForm : std::uint8_t {
  kWeights,     ///< l0 z0 + l1 z1 + l2 z2
  kDeltas,      ///< z0 + l1 (z1 - z0) + l2 (z2 - z0)
  kPerspective  ///< (sum l_i z_i / w_i) / (sum l_i / w_i)
};

/// The ways to measure how near a sample is to the triangle's edges.
enum class WireframeForm : std::uint8_t {
  kWeight,      ///< min l_i: a distance in units of the heights
  kDerivative,  ///< min l_i / fwidth(l_i): pixels in the L1 norm of the gradient
  kHeight       ///< min l_i H_i: pixels
};

struct Corner {
  Point2 at;
  double w = 1;
};

/// What a subject states of its weights and of what it interpolates, before any is asked for.
class BarycentricBounds {
 public:
  virtual ~BarycentricBounds() = default;

  /// A proven bound on |Weights[i] - lambda_i|, or NaN where none is claimed.
  virtual std::array<double, 3> WeightErrorBounds(BarycentricForm form,
                                                  const std::array<Point2, 3>& v,
                                                  Point2 p) const = 0;
  /// A proven bound on |l0 + l1 + l2 - 1| (the sum taken exactly), or NaN where none is claimed.
  virtual double SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                               Point2 p) const = 0;
  /// A proven bound on the distance from the exact interpolated value, or NaN.
  virtual double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                         const std::array<double, 3>& attribute,
                                         Point2 p) const = 0;
};

/// Weights and what is interpolated with them, for subjects that show them.
class WeightEvaluator : public BarycentricBounds {
 public:
  /// Weights of p: entry i belongs to vertex i.
  virtual std::array<double, 3> Weights(BarycentricForm form, const std::array<Point2, 3>& v,
                                        Point2 p) const = 0;
  virtual double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                             const std::array<double, 3>& attribute, Point2 p) const = 0;
  /// Distance of p to each edge line, entry i for the edge opposite vertex i, in the form's unit.
  virtual std::array<double, 3> EdgeDistances(WireframeForm form, const std::array<Point2, 3>& v,
                                              Point2 p) const = 0;
};

/// What a subject's coverage comes back as.
enum class CoverageKind : std::uint8_t {
  kFacingCounts,  ///< how many triangles of each facing cover the sample
  kCounts,        ///< how many triangles cover the sample, all of them in `front`
  kMask,          ///< 1 in `front` where anything covers the sample
  kWinners,       ///< which triangle won the sample
  kFragments      ///< the winner, its weights and its depth
};

/// Which of several triangles on a sample wins it.
enum class WinnerOrder : std::uint8_t { kLastDrawn, kFirstDrawn };

/// The vertices that a subject's weights belong to: as given, or on the profile's subpixel grid.
enum class WeightsOf : std::uint8_t { kGiven, kSnapped };

/// What a subject says of the fragments that it shows.
struct FragmentClaims {
  WinnerOrder order = WinnerOrder::kLastDrawn;
  WeightsOf weights_of = WeightsOf::kGiven;
  /// Most that a weight is off, absolute. 0: it says nothing.
  double weight_error = 0;
  /// Most that a depth is off, absolute, in the unit of z. 0: it says nothing.
  double depth_error = 0;
};

/// What a subject says of the edge values that it shows, in one number each.
struct EdgeClaims {
  bool shows_values = false;
  bool shows_walks = false;
  /// A value of E(a, b; p) is off by at most so many u of the size of its two products,
  /// |(p.x - a.x)(b.y - a.y)| + |(p.y - a.y)(b.x - a.x)|. 0: exact. Nothing: nothing is said.
  std::optional<double> value_error;
  /// After n steps a walk is off by at most (n + 1) times so many u of the larger size at its two
  /// ends.
  std::optional<double> walk_error;

  friend bool operator==(const EdgeClaims&, const EdgeClaims&) = default;
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
  /// claim.
  bool takes_threads = false;
  /// Whether the other members of DrawOptions are obeyed.
  bool takes_tiles = true;
  bool takes_scissor = true;
  bool takes_culling = true;
  CoverageKind coverage = CoverageKind::kFacingCounts;
  /// True if it draws several scenes in one call.
  bool takes_batches = false;
  /// For the kinds kWinners and kFragments.
  FragmentClaims fragments;
  /// For subjects that show edge values and state their bounds as numbers.
  EdgeClaims edges;
  /// True if its method claims 0 wrong samples against its own profile. Methods of reference/ and
  /// deciders of exact/ alone; nothing that comes from outside sets it.
  bool claims_exact = false;
  /// What is proved of its arithmetic. Methods of reference/ alone.
  std::vector<Proof> proofs;
};

/// Returns whether a call tells which triangle won each sample.
inline bool ShowsWinners(const SubjectInfo& info) {
  return info.coverage == CoverageKind::kWinners || info.coverage == CoverageKind::kFragments;
}

/// Anything that draws triangles.
class Subject {
 public:
  virtual ~Subject() = default;

  virtual const SubjectInfo& Info() const = 0;
  /// Adds the coverage of every triangle of the scene to `counts`.
  ///
  /// Domain:     a scene that Takes() accepts; counts of the scene's and the profile's shape.
  /// Properties: never writes outside the target or the scissor; equal calls give equal counts.
  /// Error:      SubjectRefusal if it refuses the scene; SubjectFault if it broke down over it, and
  ///             SubjectTooSlow if it took longer than it may (the next call starts it afresh).
  virtual void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) = 0;
  /// Draws onto a target of its own and gives back all that the subject shows.
  ///
  /// Error:      as Draw.
  virtual Drawing Show(const DrawJob& job);
  /// Draws independent scenes, in order, each onto a target of its own: in one call where the
  /// subject takes batches.
  ///
  /// Returns:    one outcome for each job; fewer if the subject broke down, and then the last one
  ///             holds what it threw. A scene that it refuses is no breakdown.
  virtual std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs);
  /// The subject whose calls each go to the rasterizer as they are. Another one than this where
  /// this splits a scene, to tell facings or overlaps that the rasterizer does not tell.
  virtual Subject& Whole() { return *this; }
  /// Draws that are not done by then may end with SubjectTooSlow. What runs in this process can't
  /// be stopped, and pays no heed.
  virtual void SetDeadline(std::chrono::steady_clock::time_point /*deadline*/) {}
  /// Optional capabilities; nullptr where the subject has none.
  virtual const EdgeEvaluator* Edges() const { return nullptr; }
  virtual const WeightEvaluator* Weights() const { return nullptr; }
};

/// A subject that died, hung, wrote where it must not, or answered what is no answer. A finding.
class SubjectFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A subject that took longer over a draw than it may: neither a finding nor a pass.
class SubjectTooSlow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A subject that says that it does not draw this scene.
class SubjectRefusal : public InputError {
 public:
  using InputError::InputError;
};

/// Returns whether the subject takes scenes of this kind and precision, and coordinates that its
/// fixed-point input can be given.
inline bool Takes(const SubjectInfo& info, const Scene& scene) {
  if (scene.clip_space ? !info.takes_clip : !info.takes_window) return false;
  if (info.profile.fixed) return CanBeGiven(scene, info.profile);  // as integers
  return info.input == Precision::kFloat64 || scene.precision == Precision::kFloat32;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_H_
