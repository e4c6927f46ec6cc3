// How a rasterizer snaps a coordinate to n.b fixed point.
#ifndef RASTERPROOF_CORE_SNAP_H_
#define RASTERPROOF_CORE_SNAP_H_

#include <cstdint>

namespace rasterproof {

/// How a coordinate between two grid points is rounded.
enum class SnapRule : std::uint8_t { kNearestEven, kNearestAway, kHalfUp, kFloor, kTruncate };

/// The number that is rounded to the grid. The three differ only where x - c is itself rounded, or
/// where the rule depends on the sign or the parity of the number.
enum class SnapForm : std::uint8_t {
  kCoordinate,         ///< snap(x)
  kFloat32Difference,  ///< c + snap(fl32(x - c)): x - c is rounded to float32 first
  kExactDifference     ///< c + snap(x - c)
};

/// The subpixel grid of a rasterizer: `bits` fractional bits, or none at all (real geometry).
struct Snap {
  static constexpr int kNone = -1;
  int bits = kNone;
  SnapRule rule = SnapRule::kNearestEven;
  SnapForm form = SnapForm::kCoordinate;
  /// The constant c of the two differences, on both axes: a multiple of 2^-8 in [0, 1), often the
  /// sample's place in its pixel. The grid is then c + 2^-bits Z. Without meaning for kCoordinate.
  double origin = 0;

  bool IsNone() const { return bits == kNone; }
  friend bool operator==(const Snap&, const Snap&) = default;
};

inline constexpr int kMaxSubpixelBits = 16;

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SNAP_H_
