// What a profile leaves to the rasterizer.
#ifndef RASTERPROOF_CORE_FREEDOM_H_
#define RASTERPROOF_CORE_FREEDOM_H_

#include <cmath>
#include <cstdint>
#include <optional>

namespace rasterproof {

/// Who owns a sample that lies exactly on an edge.
enum class TieOwnership : std::uint8_t {
  kStated,       ///< the triangle that the profile's tie rule names
  kAxisAligned,  ///< the one that a consistent tie rule names: any of the eight, one for everything
  /// Of two triangles on either side of a common edge exactly one, chosen afresh for each sample.
  /// On other edges, and at vertices, nothing is stated.
  kPerEdge,
  kOpen  ///< nothing is stated: none, one or several of the triangles
};

/// At most this many steps of tolerance: a coordinate then has two grid points to choose from, or
/// three if it is one.
inline constexpr double kMaxSnapTolerance = 1;
/// The unit of `transform_error`: a rounding to nearest in float32 is off by so much of the result.
inline constexpr double kTransformErrorUnit = 0x1p-24;

/// What a profile leaves to the rasterizer. Nothing, unless it is said.
struct Freedom {
  /// A vertex may take any grid point within so many steps of the grid, on each axis (D3D: 0.6).
  /// 0: the one that the snap rule names.
  double snap_tolerance = 0;
  /// The rounding is not stated: a vertex may take any grid point less than one step away, on each
  /// axis.
  bool any_rounding = false;
  /// The grid has so many subpixel bits or more, one number for everything; or there is none, and
  /// vertices stay where they are.
  /// Nothing: as many as the profile's snap has.
  std::optional<int> least_bits = {};
  TieOwnership ties = TieOwnership::kStated;
  /// What a window coordinate that the rasterizer computes from clip space may be off before it is
  /// snapped: so many kTransformErrorUnit of its size. Nothing: no error is stated, and so nothing
  /// of where clip space lies.
  std::optional<double> transform_error = 0;

  bool IsNone() const {
    return !MovesVertices() && ties == TieOwnership::kStated && transform_error == 0.0;
  }
  /// Whether legal models put a vertex of window space at different grid points.
  bool MovesVertices() const { return snap_tolerance != 0 || any_rounding || least_bits; }
  /// How far the window coordinate near `x` may be off, in pixels, where an error is stated.
  double TransformReach(double x) const {
    return transform_error.value_or(0) * kTransformErrorUnit * std::fabs(x);
  }
  friend bool operator==(const Freedom&, const Freedom&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FREEDOM_H_
