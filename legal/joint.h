// Does one legal model explain all that was drawn?
#ifndef RASTERPROOF_LEGAL_JOINT_H_
#define RASTERPROOF_LEGAL_JOINT_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "legal/choices.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// What was drawn, of whichever kind is known. Facings are not looked at.
struct Observed {
  /// Each triangle drawn alone, in the scene's order; empty if not known.
  std::vector<const CoverageCounts*> alone;
  /// All of them in one call: how often each sample was covered; nullptr if not known.
  const CoverageCounts* together = nullptr;
  /// The counts of one call are 1 wherever they are not 0.
  bool is_mask = false;
  /// The triangle that is visible at each sample, or kNoPrimitive; nullptr if not known.
  const std::vector<std::int32_t>* primitive_ids = nullptr;
  /// Of the triangles that cover a sample the last one is visible, else the first.
  bool last_is_visible = true;
};

enum class Legality : std::uint8_t {
  kLegal,     ///< one model explains everything
  kNotLegal,  ///< no model does
  kNotJudged  ///< none was found, and some component was given up
};

/// One thing that was seen, and that a legal model has to explain.
struct Requirement {
  std::size_t sample = 0;  ///< index in counts of the target
  Point2 at;               ///< in screen axes
  /// Those that some legal model lets cover it: all of them together were seen to, so often.
  std::vector<std::size_t> triangles;
  int least = 0;
  int most = 0;  ///< more than `least` of a picture, which does not say how often
  /// The triangle that was seen there instead of a number; kNoPrimitive: none of them.
  std::optional<std::int32_t> visible;
  /// How often legal models let them cover it.
  int legal_least = 0;
  int legal_most = 0;
};

/// Why no legal model explains what was drawn: a sample whose value no model has, or samples that
/// none explains together.
struct Core {
  std::vector<Requirement> requirements;
  /// Samples whose value no model has; of these the first is the only requirement.
  std::size_t wrong_by_themselves = 0;
  std::vector<std::size_t> vertices;  ///< of the scene, whose places decide several requirements
  /// Whether some model explains the others, whichever is left out. False: the search for fewer
  /// was cut short.
  bool is_minimal = true;
};

struct JointVerdict {
  Legality legality = Legality::kLegal;
  /// The family that explains everything; else the first of the profile's.
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

/// Returns why the joint verdict is not for this scene and profile, or nothing if it is.
std::optional<std::string> WhyNotJoint(const Scene& scene, const TargetProfile& profile);

/// Returns whether one legal model of the profile explains the drawing.
///
/// A model is: a grid and a tie rule for everything, a legal place for each vertex, and owners of
/// the samples on edges, as the profile's freedom says. Vertices of equal coordinates have one
/// place. Samples on which all models agree are compared; the rest falls into components, each of
/// which a SAT solver decides exactly.
///
/// Domain:     WhyNotJoint says nothing. What was drawn has the shape of the target.
/// Cost:       a scan of each triangle's box for each family, and the solver.
JointVerdict JudgeJointly(const Scene& scene, const TargetProfile& profile,
                          const Observed& observed, const Effort& effort = {});

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_JOINT_H_
