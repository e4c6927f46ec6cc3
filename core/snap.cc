#include "core/snap.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace rasterproof {
namespace {

constexpr std::array<std::pair<SnapRule, std::string_view>, 5> kRuleNames{{
    {SnapRule::kNearestEven, "nearest-even"},
    {SnapRule::kNearestAway, "nearest-away"},
    {SnapRule::kHalfUp, "half-up"},
    {SnapRule::kFloor, "floor"},
    {SnapRule::kTruncate, "truncate"},
}};

// The fraction v - trunc(v) is exact for every v; v - floor(v) is not: for -0.5 + 2^-54 it rounds
// to a tie.
double RoundByRule(double v, SnapRule rule) {
  const double whole = std::trunc(v);
  const double fraction = v - whole;  // has v's sign
  const double away = whole + (v < 0 ? -1 : 1);
  const double nearer = std::fabs(fraction) < 0.5 ? whole : away;
  const bool tie = std::fabs(fraction) == 0.5;
  switch (rule) {
    case SnapRule::kNearestEven:
      return tie && std::fmod(whole, 2.0) == 0 ? whole : nearer;
    case SnapRule::kNearestAway:
      return nearer;
    case SnapRule::kHalfUp:
      return tie && v < 0 ? whole : nearer;
    case SnapRule::kFloor:
      return v < 0 && fraction != 0 ? away : whole;
    case SnapRule::kTruncate:
      return whole;
  }
  return whole;
}

}  // namespace

double SnapCoordinate(double x, const Snap& snap) {
  if (snap.IsNone() || !std::isfinite(x)) return x;
  constexpr double kAllIntegersFrom = 0x1p52;  // every double of this magnitude is an integer
  if (std::fabs(x) >= kAllIntegersFrom) return x;
  // Scaling by a power of two is exact: |x| 2^bits < 2^68, and a subnormal x only grows.
  const double scaled = std::ldexp(x, snap.bits);
  if (std::fabs(scaled) >= kAllIntegersFrom) return x;
  return std::ldexp(RoundByRule(scaled, snap.rule), -snap.bits) + 0.0;
}

std::string_view SnapRuleName(SnapRule rule) {
  for (const auto& [value, name] : kRuleNames) {
    if (value == rule) return name;
  }
  return "";
}

std::optional<SnapRule> SnapRuleFromName(std::string_view name) {
  for (const auto& [value, text] : kRuleNames) {
    if (text == name) return value;
  }
  return std::nullopt;
}

}  // namespace rasterproof
