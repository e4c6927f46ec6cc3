// The choices that a profile leaves to the rasterizer.
#ifndef RASTERPROOF_CORE_FREEDOM_H_
#define RASTERPROOF_CORE_FREEDOM_H_

#include <cmath>
#include <cstdint>
#include <optional>

namespace rasterproof {

/// Who owns a sample that lies exactly on an edge.
enum class TieOwnership : std::uint8_t {
  kStated,       ///< the triangle that the profile's tie rule names
  kAxisAligned,  ///< the one that some consistent tie rule names, the same rule for everything
  /// Exactly one of the two triangles on either side of a common edge, chosen for each sample by
  /// itself. On other edges, and at vertices, nothing is stated.
  kPerEdge,
  kOpen  ///< nothing is stated: none, one or several of the triangles
};

/// The largest snap tolerance, in steps. A coordinate then has two grid points to choose from, or
/// three if it lies on one.
inline constexpr double kMaxSnapTolerance = 1;
/// The unit of `transform_error`: the relative error of a rounding to nearest in float32.
inline constexpr double kTransformErrorUnit = 0x1p-24;

/// The choices that a profile leaves to the rasterizer. By default it leaves none.
struct Freedom {
  /// A vertex may take any grid point at most this many steps away, on each axis (D3D: 0.6).
  /// 0: the grid point that the snap rule names.
  double snap_tolerance = 0;
  /// The rounding is not stated: a vertex may take any grid point less than one step away, on each
  /// axis.
  bool any_rounding = false;
  /// The grid has at least this many subpixel bits, the same number for everything; or there is no
  /// grid, and vertices stay where they are. Nothing: the grid is the profile's snap.
  std::optional<int> least_bits = {};
  TieOwnership ties = TieOwnership::kStated;
  /// The error that a window coordinate computed from clip space may have before it is snapped, in
  /// units of kTransformErrorUnit times its size. Nothing: no error is stated, and so it is not
  /// stated where clip space lies.
  std::optional<double> transform_error = 0;

  bool IsNone() const {
    return !MovesVertices() && ties == TieOwnership::kStated && transform_error == 0.0;
  }
  /// Whether legal models put a vertex of window space at different grid points.
  bool MovesVertices() const { return snap_tolerance != 0 || any_rounding || least_bits; }
  /// How far the window coordinate near `x` may be off, in pixels; 0 if no error is stated.
  double TransformReach(double x) const {
    return transform_error.value_or(0) * kTransformErrorUnit * std::fabs(x);
  }
  friend bool operator==(const Freedom&, const Freedom&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FREEDOM_H_
