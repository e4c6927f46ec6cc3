// Who owns a sample that lies exactly on an edge.
#ifndef RASTERPROOF_CORE_TIE_RULE_H_
#define RASTERPROOF_CORE_TIE_RULE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rasterproof {

/// A consistent tie rule, written as the infinitesimal shift of the sample that decides it.
///
/// With e -> 0+ the sample moves by (sign_x * e, sign_y * e^2), or by (sign_x * e^2, sign_y * e) if
/// `y_first`. The shifted sample lies on no edge, so a planar subdivision owns it exactly once.
/// Axes are those of the screen: x right, y down. Top-left is (+e, +e^2).
struct TieRule {
  std::int8_t sign_x = +1;
  std::int8_t sign_y = +1;
  bool y_first = false;
  /// True for "a sample on any edge is inside" (`>=` on all edges). It is not a consistent rule:
  /// shared edges are covered twice. Only the profile of a subject that does this uses it.
  bool inclusive = false;
  /// True for "a sample on any edge is outside" (`>` on all edges): shared edges are never covered.
  bool exclusive = false;

  /// Whether a planar subdivision owns every sample once.
  bool IsConsistent() const { return !inclusive && !exclusive; }

  friend bool operator==(const TieRule&, const TieRule&) = default;
};

inline constexpr TieRule kTopLeft{};

/// The eight consistent rules, top-left first.
inline constexpr std::array<TieRule, 8> kConsistentRules{{{+1, +1, false, false, false},
                                                          {+1, -1, false, false, false},
                                                          {-1, +1, false, false, false},
                                                          {-1, -1, false, false, false},
                                                          {+1, +1, true, false, false},
                                                          {+1, -1, true, false, false},
                                                          {-1, +1, true, false, false},
                                                          {-1, -1, true, false, false}}};

/// Returns the rule's name: "top-left", "top-right", "bottom-left", "bottom-right", the same four
/// with "-y" appended when y moves first ("top-left-y"), "inclusive" or "exclusive".
std::string TieRuleName(const TieRule& rule);

/// Returns the rule of a name that TieRuleName gives, or nothing.
std::optional<TieRule> TieRuleFromName(std::string_view name);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TIE_RULE_H_
