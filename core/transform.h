// The operations by which a rasterizer goes from clip space, or from a map, to window space.
#ifndef RASTERPROOF_CORE_TRANSFORM_H_
#define RASTERPROOF_CORE_TRANSFORM_H_

#include <cstdint>
#include <optional>

#include "core/scene.h"

namespace rasterproof {

/// How a clip-space coordinate is divided by w.
enum class Division : std::uint8_t {
  kQuotient,   ///< x / w
  kReciprocal  ///< x * (1 / w)
};

/// How the quotient q becomes a place on the target, half of whose size is h.
enum class ViewportForm : std::uint8_t {
  kNone,         ///< q: clip space is scaled to the viewport already
  kMultiplyAdd,  ///< q * h + h
  kFused,        ///< fma(q, h, h)
  kAddMultiply   ///< (q + 1) * h
};

/// A map's coordinates on a target: the corner of its first pixel, and the steps to the next column
/// and to the next row. On maps with y up, dy is negative.
struct MapGrid {
  double x0 = 0;
  double y0 = 0;
  double dx = 1;
  double dy = 1;

  friend bool operator==(const MapGrid&, const MapGrid&) = default;
};

/// The transform that a rasterizer owns: every operation rounds to nearest in `precision`.
///
/// With a map the given coordinates are the map's, never clip space: x becomes (x - x0) / dx, or
/// (x - x0) * (1 / dx), as `division` says; viewport and flip apply to clip space only.
/// A rasterizer without a transform takes window space, or is held to the exact quotients.
struct Transform {
  Precision precision = Precision::kFloat32;
  Division division = Division::kQuotient;
  ViewportForm viewport = ViewportForm::kNone;
  /// Clip space has y up where the target has it down: -q takes the place of q along y.
  bool flips_y = false;
  std::optional<MapGrid> map = {};

  friend bool operator==(const Transform&, const Transform&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TRANSFORM_H_
