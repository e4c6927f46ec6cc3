#include "props/authority.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/from_chars.h"
#include "core/value_rule.h"

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
  FromChars(value.data(), value.data() + value.size(), half_width,
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

// The profile's word for a key of its values; empty if it states none.
std::string_view WordOf(std::string_view key, const Profile& profile) {
  const ValueRule& values = profile.values;
  if (key == "values.provoking" && values.provoking != ProvokingVertex::kUnstated)
    return values.provoking == ProvokingVertex::kFirst ? "first" : "last";
  // No text says where quads begin: who states it adds a promise of its own.
  if (key == "values.derivatives" && values.derivatives == DerivativesBy::kFine)
    return values.quads == QuadOrigin::kUnstated ? "fine" : "";
  if (key == "values.depth" &&
      (values.depth == DepthFormat::kUnorm16 || values.depth == DepthFormat::kUnorm24 ||
       values.depth == DepthFormat::kUnorm32))
    return "unorm";
  if (key == "values.depth_rounding")
    return values.depth_rounding == DepthRounding::kEither ? "either" : "nearest";
  // One sample is at the centre.
  if (key == "values.centres")
    return values.centres && profile.pattern.locations.size() > 1 ? "true" : "false";
  return "";
}

// Whether the clause is about other values than the profile's: another provoking vertex's, say.
bool IsOfOtherValues(const Clause& clause, const Profile& profile) {
  return std::ranges::any_of(KeysOf(clause), [&](const ClauseKey& key) {
    return key.key.starts_with("values.") && !key.value.empty() &&
           WordOf(key.key, profile) != key.value;
  });
}

// Whether the subject states how far off the numbers may be that the property looks at.
bool StatesItsError(const Gate& gate, const SubjectInfo& info) {
  if (gate.shows == Shows::kValues) return info.profile.values.error.IsStated();
  if (gate.shows == Shows::kDepths) return info.fragments.depth_error > 0;
  return info.fragments.barycentric_error > 0;
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
    if (IsOfOtherSquares(*clause, profile) || IsOfOtherValues(*clause, profile)) continue;
    clauses.push_back(clause);
  }
  return clauses;
}

Grounds AuthorityOf(const Property& property, const SubjectInfo& info) {
  if (StatesItsError(property.gate, info)) {
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
