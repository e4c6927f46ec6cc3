// Which rules a drawing breaks that no legal model explains, and the clauses that require them.
#ifndef RASTERPROOF_TOOL_LEGAL_BROKEN_RULES_H_
#define RASTERPROOF_TOOL_LEGAL_BROKEN_RULES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/profile.h"
#include "core/scene.h"
#include "legal/joint.h"

namespace rasterproof::tool {

/// What the models of a profile keep, in the order in which it is left out to see what a drawing
/// breaks.
enum class BrokenRule : std::uint8_t {
  kFacing,       ///< which side of a triangle is counted as its front
  kVisible,      ///< which of the triangles that cover a sample is visible
  kZeroArea,     ///< what a triangle of zero area covers
  kNotFinite,    ///< what a triangle with a vertex that is not finite covers
  kEdgeOwner,    ///< who owns a sample on an edge
  kPlacedSample  ///< which samples off the edges of a legally placed triangle it covers
};

/// Returns the rules that the drawing breaks.
///
/// The first rules are left out one after the other. One is broken if a model explains without it
/// the whole drawing, or some sample that no model explained by itself before. kPlacedSample is
/// broken if no model explains the drawing without all the others.
///
/// Domain:     legal::JudgeJointly() gave `verdict` of these.
/// Returns:    at least one rule of a drawing that is not legal, none of another.
/// Cost:       up to five more joint verdicts.
std::vector<BrokenRule> BrokenRules(const Scene& scene, const Profile& profile,
                                    const legal::Observed& observed,
                                    const legal::JointVerdict& verdict);

/// The clauses of the profile's specification that require one of the rules, in the order of the
/// rules. Empty if the profile is no specification's, or it says nothing of them.
std::vector<const Clause*> ClausesOf(const std::vector<BrokenRule>& rules, const Profile& profile);

/// A line for each clause, with its sentence: "required by      vulkan.common-edge: Of two ...". A
/// rule that no clause requires is the stated model's.
std::string BrokenRuleLines(const std::vector<BrokenRule>& rules, const Profile& profile);
/// The same without sentences: "required by vulkan.common-edge", "by the stated model: who owns a
/// sample on an edge".
std::string BrokenRuleText(const std::vector<BrokenRule>& rules, const Profile& profile);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_BROKEN_RULES_H_
