#include "props/authority.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rasterproof::props {
namespace {

// What the subject shows beside its coverage is held to the bounds that it states itself.
bool IsJudgedByStatedBounds(const Gate& gate) {
  return gate.shows == Shows::kEdgeValues || gate.shows == Shows::kSteps ||
         gate.shows == Shows::kBarycentrics;
}

std::string_view NameOf(SquareRelation relation) {
  return relation == SquareRelation::kIntersects ? "intersects" : "contains";
}

std::string_view NameOf(FlatSquares flat) {
  if (flat == FlatSquares::kNothing) return "nothing";
  return flat == FlatSquares::kFree ? "free" : "drawn";
}

bool SaysOtherwise(const ClauseKey& key, const std::optional<SquareRegion>& region) {
  if (key.key.ends_with(".relation")) return !region || NameOf(region->relation) != key.value;
  if (!key.key.ends_with(".half_width") || key.value.empty()) return false;
  std::string_view value = key.value;
  const bool is_hex = value.starts_with("0x");
  if (is_hex) value.remove_prefix(2);
  double half_width = 0;
  std::from_chars(value.data(), value.data() + value.size(), half_width,
                  is_hex ? std::chars_format::hex : std::chars_format::general);
  return !region || half_width != region->half_width;
}

// Whether the clause is about other squares than the profile's: another tier's, say.
bool IsOfOtherSquares(const Clause& clause, const Profile& profile) {
  if (!profile.squares) return false;
  const SquareRule& rule = *profile.squares;
  return std::ranges::any_of(KeysOf(clause), [&](const ClauseKey& key) {
    if (key.key == "coverage.flat") return key.value != NameOf(rule.flat);
    if (key.key.starts_with("coverage.must.")) return SaysOtherwise(key, rule.must);
    return key.key.starts_with("coverage.may.") && SaysOtherwise(key, rule.may);
  });
}

// Whether it follows from the profile, or from what the subject states beside it.
bool FollowsFromTheProfile(const Property& property, const Profile& profile,
                           bool is_of_a_specification) {
  if (property.stated_by != nullptr && !property.stated_by(profile)) return false;
  return !is_of_a_specification || HasOneModel(profile) || IsJudgedByStatedBounds(property.gate);
}

}  // namespace

std::vector<const Clause*> ClausesFor(std::span<const std::string_view> ids,
                                      const Profile& profile) {
  const Specification* specification = SpecificationOf(profile);
  std::vector<const Clause*> clauses;
  if (specification == nullptr) return clauses;
  for (const std::string_view id : ids) {
    const Clause* clause = FindClause(id);
    if (clause == nullptr) continue;  // a test sees to it that there is none
    const std::string_view api = ApiOf(*clause);
    if (api != specification->api && api != specification->base) continue;
    if (IsOfOtherSquares(*clause, profile)) continue;
    clauses.push_back(clause);
  }
  return clauses;
}

Grounds AuthorityOf(const Property& property, const SubjectInfo& info) {
  const bool states_error = info.fragments.barycentric_error > 0;
  if (states_error) {
    std::vector<const Clause*> clauses = ClausesFor(property.required_with_error, info.profile);
    if (!clauses.empty()) return {Authority::kClause, std::move(clauses)};
  }
  return AuthorityOf(property, info.profile);
}

Grounds AuthorityOf(const Property& property, const Profile& profile) {
  std::vector<const Clause*> clauses = ClausesFor(property.required_by, profile);
  if (!clauses.empty()) return {Authority::kClause, std::move(clauses)};
  const bool is_stated =
      FollowsFromTheProfile(property, profile, SpecificationOf(profile) != nullptr);
  return {is_stated ? Authority::kStatedModel : Authority::kQuality, {}};
}

}  // namespace rasterproof::props
