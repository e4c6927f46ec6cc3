// The placing of a scene's vertices by a profile's model: all stages in their order.
#ifndef RASTERPROOF_MODEL_SNAP_SCENE_H_
#define RASTERPROOF_MODEL_SNAP_SCENE_H_

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "model/target_profile.h"

namespace rasterproof {

/// What a profile says of a triangle by which of its numbers are finite.
enum class Finiteness : std::uint8_t {
  kPlaced,         ///< what its places say: x, y and w are finite, and z is or changes nothing
  kCoversNothing,  ///< that it covers nothing
  kUnstated        ///< nothing: it may cover anything
};

/// A NaN in z that covers nothing decides before one in x, y or w, and that before an infinity.
Finiteness FinitenessOf(const std::array<Vertex, 3>& corners, const Profile& profile);

/// Returns the scene with every vertex where the model puts it: x and y wrapped into the range of
/// its fixed-point input and on the subpixel grid; a vertex of NaN z has no place (x is NaN) where
/// `nan_z` says that it covers nothing.
///
/// Domain:     window-space scenes; w is 1. Clip-space scenes that are not homogeneous: they go
///             through the profile's transform first. (Others snap after the division: see exact/.)
Scene SnapVertices(const Scene& scene, const TargetProfile& profile);

/// Returns whether the model drops triangle t of the placed scene for its extent.
bool IsDropped(const Scene& placed, std::size_t t, const Profile& profile);

/// Returns SnapVertices() with the three corners of each dropped triangle in one place. Triangles
/// keep their indices.
Scene SnapScene(const Scene& scene, const TargetProfile& profile);

/// Returns whether the guard-band rectangle, if there is one, holds every vertex that a triangle
/// uses.
bool IsUnclipped(const Scene& scene, const TargetProfile& profile);

/// Returns whether clipping may move edges of the scene, and the profile does not say how far:
/// nothing is then stated of the samples of what leaves the guard band.
inline bool MayMoveEdgesAnyhow(const Scene& scene, const TargetProfile& profile) {
  return profile.guard_band && !MovesClippedEdges(profile) && !IsUnclipped(scene, profile);
}

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_SNAP_SCENE_H_
