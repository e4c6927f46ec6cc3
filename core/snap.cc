#include "core/snap.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace rasterproof {
namespace {

template <class E>
using NameTable = std::span<const std::pair<E, std::string_view>>;

template <class E>
std::string_view NameOf(E value, NameTable<E> names) {
  for (const auto& [known, name] : names) {
    if (known == value) return name;
  }
  return "";
}

template <class E>
std::optional<E> FromName(std::string_view name, NameTable<E> names) {
  for (const auto& [known, text] : names) {
    if (text == name) return known;
  }
  return std::nullopt;
}

constexpr std::array<std::pair<SnapRule, std::string_view>, 5> kRuleNames{{
    {SnapRule::kNearestEven, "nearest-even"},
    {SnapRule::kNearestAway, "nearest-away"},
    {SnapRule::kHalfUp, "half-up"},
    {SnapRule::kFloor, "floor"},
    {SnapRule::kTruncate, "truncate"},
}};

constexpr std::array<std::pair<SnapForm, std::string_view>, 3> kFormNames{{
    {SnapForm::kCoordinate, "coordinate"},
    {SnapForm::kFloat32Difference, "float32-difference"},
    {SnapForm::kExactDifference, "exact-difference"},
}};

}  // namespace

std::string_view SnapRuleName(SnapRule rule) { return NameOf<SnapRule>(rule, kRuleNames); }

std::optional<SnapRule> SnapRuleFromName(std::string_view name) {
  return FromName<SnapRule>(name, kRuleNames);
}

std::string_view SnapFormName(SnapForm form) { return NameOf<SnapForm>(form, kFormNames); }

std::optional<SnapForm> SnapFormFromName(std::string_view name) {
  return FromName<SnapForm>(name, kFormNames);
}

}  // namespace rasterproof
