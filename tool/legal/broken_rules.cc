#include "tool/legal/broken_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/vertex.h"
#include "exact/edge.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "legal/owners.h"
#include "model/target_profile.h"
#include "props/authority.h"
#include "props/properties/clause_lists.h"

namespace rasterproof::tool {
namespace {

struct RuleRow {
  BrokenRule rule;
  std::span<const std::string_view> clauses;
  std::string_view words;
};

constexpr std::array<RuleRow, 6> kRuleRows{{
    {BrokenRule::kFacing, props::kFacingClauses, "which side of a triangle is its front"},
    {BrokenRule::kVisible, props::kOrderClauses, "which of several triangles is visible"},
    {BrokenRule::kZeroArea, props::kZeroAreaClauses, "what a triangle of zero area covers"},
    {BrokenRule::kNotFinite, props::kNanClauses, "what a vertex that is not finite draws"},
    {BrokenRule::kEdgeOwner, props::kEdgeOwnerClauses, "who owns a sample on an edge"},
    {BrokenRule::kPlacedSample, props::kPlacedSampleClauses,
     "samples inside a placed triangle are covered, others are not"},
}};
static_assert(std::ranges::is_sorted(kRuleRows, {}, &RuleRow::rule));

const RuleRow& RowOf(BrokenRule rule) { return kRuleRows[static_cast<std::size_t>(rule)]; }

bool HasFlatTriangle(const Scene& scene) {
  if (scene.clip_space) return false;
  return std::ranges::any_of(scene.triangles, [&](const Triangle& triangle) {
    std::array<Point2, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& v = scene.vertices[static_cast<std::size_t>(triangle[k])];
      if (!IsFinite(v)) return false;
      at[k] = {v.x, v.y};
    }
    return exact::EdgeSign(at[0], at[1], at[2]) == 0;
  });
}

bool HasInfiniteVertexOrNan(const Scene& scene) {
  return std::ranges::any_of(scene.vertices,
                             [](const Vertex& v) { return !IsFinite(v) || !std::isfinite(v.z); });
}

// Leaves the rule out of the profile, or out of what is observed. False: it was not in.
bool LeaveOut(BrokenRule rule, const Scene& scene, Profile& profile, legal::Observed& observed) {
  switch (rule) {
    case BrokenRule::kFacing:
      if (observed.sides == legal::Sides::kNotCompared) return false;
      observed.sides = legal::Sides::kNotCompared;
      return true;
    case BrokenRule::kVisible:
      if (observed.primitive_ids == nullptr || observed.any_is_visible) return false;
      observed.any_is_visible = true;
      return true;
    case BrokenRule::kZeroArea:
      if (profile.degenerate_triangles == DegenerateTriangles::kUnspecified) return false;
      profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
      return HasFlatTriangle(scene);
    case BrokenRule::kNotFinite:
      profile.infinite_vertex = InfiniteVertex::kUnspecified;
      profile.nan_vertex = NanVertex::kUnspecified;
      profile.nan_z = NanZ::kUnspecified;
      return HasInfiniteVertexOrNan(scene);
    case BrokenRule::kEdgeOwner:
      if (legal::OwnersOfTies(profile) == TieOwnership::kOpen) return false;
      profile.freedom.ties = TieOwnership::kOpen;
      return true;
    case BrokenRule::kPlacedSample:
      break;
  }
  return false;
}

std::size_t WrongOf(const legal::JointVerdict& verdict) {
  return verdict.core ? verdict.core->wrong_by_themselves : 0;
}

}  // namespace

std::vector<BrokenRule> BrokenRules(const Scene& scene, const Profile& profile,
                                    const legal::Observed& observed,
                                    const legal::JointVerdict& verdict) {
  if (verdict.legality != legal::Legality::kNotLegal) return {};
  Profile weaker = profile;
  legal::Observed seen = observed;
  std::vector<BrokenRule> broken;
  std::size_t wrong = WrongOf(verdict);
  for (const RuleRow& row : kRuleRows) {
    if (!LeaveOut(row.rule, scene, weaker, seen)) continue;
    const legal::JointVerdict without =
        legal::JudgeJointly(scene, TargetProfile(weaker, scene), seen);
    const std::size_t left = WrongOf(without);
    if (without.legality != legal::Legality::kNotLegal || left < wrong) broken.push_back(row.rule);
    if (without.legality == legal::Legality::kLegal) return broken;
    if (without.legality == legal::Legality::kNotJudged) break;  // one of the two it is
    wrong = left;
  }
  broken.push_back(BrokenRule::kPlacedSample);
  return broken;
}

std::vector<const Clause*> ClausesOf(const std::vector<BrokenRule>& rules, const Profile& profile) {
  std::vector<const Clause*> all;
  for (const BrokenRule rule : rules) {
    const std::vector<const Clause*> more = props::ClausesFor(RowOf(rule).clauses, profile);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string BrokenRuleLines(const std::vector<BrokenRule>& rules, const Profile& profile) {
  constexpr std::string_view kLine = "{:<16} {}: {}\n";
  std::string lines;
  for (const BrokenRule rule : rules) {
    const RuleRow& row = RowOf(rule);
    const std::vector<const Clause*> clauses = props::ClausesFor(row.clauses, profile);
    for (const Clause* clause : clauses)
      lines += fmt::format(kLine, "required by", clause->id, clause->sentence);
    if (clauses.empty()) lines += fmt::format(kLine, "required by", "the stated model", row.words);
  }
  return lines;
}

std::string BrokenRuleText(const std::vector<BrokenRule>& rules, const Profile& profile) {
  std::vector<std::string_view> ids;
  std::vector<std::string_view> words;
  for (const BrokenRule rule : rules) {
    const std::vector<const Clause*> clauses = props::ClausesFor(RowOf(rule).clauses, profile);
    for (const Clause* clause : clauses) ids.push_back(clause->id);
    if (clauses.empty()) words.push_back(RowOf(rule).words);
  }
  std::string text;
  if (!ids.empty()) text = fmt::format("required by {}", fmt::join(ids, ", "));
  if (!words.empty()) {
    text +=
        fmt::format("{}by the stated model: {}", text.empty() ? "" : "; ", fmt::join(words, "; "));
  }
  return text;
}

}  // namespace rasterproof::tool
