// Decides whether one legal model explains all of a drawing.
#ifndef RASTERPROOF_LEGAL_JOINT_H_
#define RASTERPROOF_LEGAL_JOINT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "legal/choices.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// Which side of a triangle the observed counts have in `front`.
enum class Sides : std::uint8_t {
  kNotCompared,
  kPositiveArea,  ///< the side that is counter-clockwise on screen
  kNegativeArea   ///< the other one
};

/// The observed drawing, in the forms that are known.
struct Observed {
  /// Each triangle drawn alone, in the scene's order; empty if not known.
  std::vector<const CoverageCounts*> alone;
  /// All of them in one call: how often each sample was covered; nullptr if not known.
  const CoverageCounts* together = nullptr;
  /// The counts of one call are 1 wherever they are not 0.
  bool is_mask = false;
  /// What the counts of one call say of facings. A triangle that legal models may turn over or
  /// flatten, and with a grid one that leaves the target, may be counted on either side.
  Sides sides = Sides::kNotCompared;
  /// Of `primitive_ids`: whether the visible triangle shows its front; nullptr if not known.
  /// Compared as `sides` says, as far as all legal models count the triangle on one side.
  const std::vector<bool>* visible_front = nullptr;
  /// By triangle, the side that all legal models of all families count it on, or 0: a facing may be
  /// that of another legal grid than the samples. JudgeJointly() fills it, if sides are compared.
  std::vector<int> side_of;
  /// The triangle that is visible at each sample, or kNoPrimitive; nullptr if not known.
  const std::vector<std::int32_t>* primitive_ids = nullptr;
  /// True if the last triangle that covers a sample is visible; false if the first is.
  bool last_is_visible = true;
  /// Which of the triangles that cover a sample is visible is not known: a depth test may decide.
  bool any_is_visible = false;

  /// Whether the visible triangle shows a side that no legal model counts it on. Needs `side_of`.
  bool ShowsWrongSide(std::size_t sample) const;
};

enum class Legality : std::uint8_t {
  kLegal,     ///< one model explains everything
  kNotLegal,  ///< no model does
  kNotJudged  ///< none was found, and some component was given up
};

/// From `least` to `most`, both included.
struct CountRange {
  int least = 0;
  int most = 0;
};

/// One observation that a legal model has to explain.
struct Requirement {
  std::size_t sample = 0;  ///< index in counts of the target
  Point2 at;               ///< in screen axes
  /// The triangles that cover it in some legal model; the observed count is that of all together.
  std::vector<std::size_t> triangles;
  int least = 0;
  int most = 0;  ///< larger than `least` for a mask, which does not show how often
  /// The triangle that was seen there, if ids were observed; kNoPrimitive: none of them.
  std::optional<std::int32_t> visible;
  /// Whether the front of `visible` was seen, if every legal model counts it on the other side.
  std::optional<bool> wrong_front;
  /// How many of them were counted as front and as back, if sides are compared.
  std::optional<std::array<int, 2>> by_side;
  /// How often legal models let them cover it.
  int legal_least = 0;
  int legal_most = 0;
  /// Of an observed id: the triangles that some legal model shows there, if `visible` is the only
  /// observation. Some legal model shows none if `legal_least` is 0.
  std::vector<std::size_t> legal_visible;
  /// If sides are compared: how many of them legal models count as front and as back.
  std::optional<std::array<CountRange, 2>> legal_by_side;
};

/// Core::wrong has no more samples than this.
inline constexpr std::size_t kMostWrongTold = 1000;

/// Why no legal model explains the drawing: a sample whose value no model has, or samples that no
/// model explains together.
struct Core {
  std::vector<Requirement> requirements;
  /// Samples whose value no model has. The first of them is then the only requirement.
  std::size_t wrong_by_themselves = 0;
  /// Those samples, in rising order, but no more than kMostWrongTold of them.
  std::vector<Requirement> wrong;
  std::vector<std::size_t> vertices;  ///< of the scene, whose places decide several requirements
  /// True if leaving out any requirement makes the rest explicable. False if the search for fewer
  /// requirements was cut short.
  bool is_minimal = true;
};

struct JointVerdict {
  Legality legality = Legality::kLegal;
  /// The family that explains everything; if none does, the profile's first.
  Family family;
  std::optional<Core> core;  ///< if not legal

  // Of that family.
  std::uint64_t samples = 0;          ///< of the target
  std::uint64_t not_judged = 0;       ///< of these: in components that were given up
  std::size_t components = 0;         ///< parts of the scene that can be judged by themselves
  std::size_t largest_component = 0;  ///< its triangles
  std::size_t largest_given_up = 0;   ///< triangles of the largest that was given up
  std::size_t families = 0;           ///< tried
};

/// How much is tried before a component is given up.
struct Effort {
  std::size_t most_open = 2'000'000;              ///< decisions of one component
  std::uint64_t most_propagations = 200'000'000;  ///< of the solver, for each question
};

/// The reason where a profile states no error of its transform, for a scene in clip space.
inline constexpr std::string_view kNoTransformError =
    "the profile states no error of its transform";
/// The reason where MayMoveEdgesAnyhow().
inline constexpr std::string_view kClippedAnyhow =
    "a triangle leaves the guard band, and the profile does not say how far clipping moves its "
    "edges";

/// Returns why the joint verdict is not for this scene and profile, or nothing if it is.
std::optional<std::string> WhyNotJoint(const Scene& scene, const TargetProfile& profile);

/// Returns whether one legal model of the profile explains the drawing.
///
/// A model consists of one grid and one tie rule, a legal place for each vertex, and owners of the
/// samples on edges, as the profile's freedom says. Vertices of equal coordinates have one place.
/// Samples on which all models agree are compared; the rest falls into components, each decided
/// exactly by a SAT solver. For single samples, see legal/decided.h.
///
/// Domain:     WhyNotJoint() returns nothing. The drawing has the shape of the target.
/// Cost:       a scan of each triangle's box for each family, and the solver.
JointVerdict JudgeJointly(const Scene& scene, const TargetProfile& profile,
                          const Observed& observed, const Effort& effort = {});

/// One of several calls: its scene, and what is known of the drawing.
struct Call {
  const Scene* scene = nullptr;
  Observed observed;
};

/// Of several calls of one rasterizer on one target.
struct CallsVerdict {
  Legality legality = Legality::kLegal;
  Family family = {};  ///< one that explains every call, if legal
  /// If not legal: by call, the families that explain it, or may where a component was given up.
  std::vector<std::vector<Family>> explaining = {};
  /// If not legal: the fewest calls that were found to have no family in common. One: no family
  /// explains it.
  std::vector<std::size_t> conflict = {};
};

/// Returns whether one family, a grid and a tie rule, explains every call.
///
/// Each call has places and owners of its own: only what is chosen once for a rasterizer is common.
/// The families are those of all vertices together, so that a grid that is finer than one call's
/// coordinates, and there equal to no grid, is still told from others by another call. They are
/// tried in their order, and each call by each family once at most. The call that refuted the last
/// family is asked first: where the first family explains all, that is one question a call.
///
/// Domain:     for each call, that of JudgeJointly(); all of one space. At least one call.
/// Returns:    kNotJudged if no family explains every call, and some may, were nothing given up.
/// Cost:       JudgeJointly's, times the calls; if not legal, times the families. Nothing is kept.
CallsVerdict JudgeCalls(const std::vector<Call>& calls, const TargetProfile& profile,
                        const Effort& effort = {});

/// Returns the families of the profile that explain the call, or may where a component was given
/// up, in the order of FamiliesOf().
std::vector<Family> ExplainingFamilies(const Call& call, const TargetProfile& profile,
                                       const Effort& effort = {});

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_JOINT_H_
