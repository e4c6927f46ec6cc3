// What a plan knows of a scene: lattice, extents, and what can happen in it.
#ifndef RASTERPROOF_REFERENCE_PLAN_SCENE_H_
#define RASTERPROOF_REFERENCE_PLAN_SCENE_H_

#include <array>
#include <optional>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "model/snap.h"
#include "reference/sample_grid.h"

namespace rasterproof::reference {

/// The corners of a triangle in window space with y down, on the profile's grid; nothing if a
/// coordinate is not finite (such a triangle covers nothing).
///
/// Domain:     window space.
template <bool kSnap>
std::optional<std::array<Point2, 3>> ScreenCorners(const Scene& scene, const Triangle& t,
                                                   const Snap& snap, const SampleGrid& grid) {
  std::array<Point2, 3> v;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& corner = scene.vertices[static_cast<std::size_t>(t[k])];
    if (!IsFinite(corner)) return std::nullopt;
    v[k] = kSnap ? Point2{SnapCoordinate(corner.x, snap), grid.Y(SnapCoordinate(corner.y, snap))}
                 : Point2{corner.x, grid.Y(corner.y)};
  }
  return v;
}

/// Numbers that the choice of arithmetic rests on. All of the snapped scene, finite triangles only.
struct SceneExtent {
  /// Every coordinate, sample locations included, is a multiple of 2^-lattice; at least 0.
  int lattice = 0;
  double largest = 0;       ///< largest |coordinate| of a vertex, in pixels
  double widest = 0;        ///< largest box side along x, rounded up; infinity beyond double
  double tallest = 0;       ///< along y
  double largest_area = 0;  ///< largest product of a box's two sides, rounded up
  bool on_grid = true;      ///< the vertices lie on the profile's grid before it snaps them
  bool inside_area = true;  ///< no box holds a sample outside the draw area
};
SceneExtent MeasureScene(const Scene& scene, const Profile& profile, const DrawOptions& options);

/// The scale of kernels in integers: 2^lattice, for scenes whose coordinates fit.
int SceneLattice(const Scene& scene, const Profile& profile);

/// The scene in window space that a clip-space scene in front of the eye snaps to: x / w goes to
/// the grid without being rounded on its way.
///
/// Error:      none inside the domain. InputError if a finite triangle has a w <= 0, x / w needs
///             more than 50 bits on the grid, or the profile snaps differences.
Scene SnapProjected(const Scene& scene, const Profile& profile);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_PLAN_SCENE_H_
