#include "core/tie_rule.h"

#include <optional>
#include <string>
#include <string_view>

namespace rasterproof {

// A sample shifted right (+x) falls into the triangle whose *left* edge it lay on, and one shifted
// down into the one whose *top* edge it lay on: sign +1 names left and top.
std::string TieRuleName(const TieRule& rule) {
  if (rule.inclusive) return "inclusive";
  if (rule.exclusive) return "exclusive";
  std::string name = rule.sign_y > 0 ? "top" : "bottom";
  name += rule.sign_x > 0 ? "-left" : "-right";
  if (rule.y_first) name += "-y";
  return name;
}

std::optional<TieRule> TieRuleFromName(std::string_view name) {
  if (name == "inclusive") return TieRule{.inclusive = true};
  if (name == "exclusive") return TieRule{.exclusive = true};
  for (const TieRule& rule : kConsistentRules) {
    if (TieRuleName(rule) == name) return rule;
  }
  return std::nullopt;
}

}  // namespace rasterproof
