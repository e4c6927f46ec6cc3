// Where a profile's model puts the vertices of a scene: all stages in their order.
#ifndef RASTERPROOF_MODEL_SNAP_SCENE_H_
#define RASTERPROOF_MODEL_SNAP_SCENE_H_

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// Returns the scene as the profile's model places it: x and y of every vertex wrapped into the
/// range of its fixed-point input and on the subpixel grid; a triangle larger than
/// `max_primitive_extent` has its three corners in one place; a vertex of NaN z has no place (x is
/// NaN) where `nan_z` says that it covers nothing. Indices of triangles stay what they are.
///
/// Domain:     window-space scenes; w is 1. Clip-space scenes that are not homogeneous: they go
///             through the profile's transform first. (Others snap after the division: see exact/.)
Scene SnapScene(const Scene& scene, const Profile& profile);

/// Returns whether the guard-band rectangle, if there is one, holds every vertex that a triangle
/// uses.
bool IsUnclipped(const Scene& scene, const Profile& profile);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_SNAP_SCENE_H_
