// Snapping of a coordinate to n.b fixed point.
#ifndef RASTERPROOF_CORE_SNAP_H_
#define RASTERPROOF_CORE_SNAP_H_

#include <cstdint>
#include <optional>
#include <string_view>

namespace rasterproof {

/// How a coordinate between two grid points is rounded.
enum class SnapRule : std::uint8_t { kNearestEven, kNearestAway, kHalfUp, kFloor, kTruncate };

/// The subpixel grid of a rasterizer: `bits` fractional bits, or none at all (real geometry).
struct Snap {
  static constexpr int kNone = -1;
  int bits = kNone;
  SnapRule rule = SnapRule::kNearestEven;

  bool IsNone() const { return bits == kNone; }
  friend bool operator==(const Snap&, const Snap&) = default;
};

inline constexpr int kMaxSubpixelBits = 16;

/// Returns the grid point of `snap` that `x` rounds to.
///
/// Domain:     any double; 0 <= snap.bits <= kMaxSubpixelBits, or kNone (returns x itself).
/// Error:      none: the result is the exact multiple of 2^-bits that the rule names. Infinity and
///             NaN come back unchanged; the result of a tiny negative x is +0.
double SnapCoordinate(double x, const Snap& snap);

/// Names: "nearest-even", "nearest-away", "half-up", "floor", "truncate".
std::string_view SnapRuleName(SnapRule rule);
std::optional<SnapRule> SnapRuleFromName(std::string_view name);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SNAP_H_
