// The stage from clip space, or from a map, to window space: each operation as a rasterizer
// computes it.
#ifndef RASTERPROOF_MODEL_TRANSFORM_H_
#define RASTERPROOF_MODEL_TRANSFORM_H_

#include "core/scene.h"
#include "core/transform.h"
#include "core/vertex.h"

namespace rasterproof {

/// Returns the window-space vertex of a vertex in clip space or on a map under the transform.
///
/// Domain:     any vertex; the target's size within a scene's limits.
/// Returns:    x and y bit for bit as the operations give them, infinities and NaN included; NaN if
///             the vertex is not finite or w is not positive, as the transform does not define
///             clipping. z is unchanged, w is 1. The w of a map's vertex is ignored.
Vertex ToWindow(const Vertex& clip, const Transform& transform, int width, int height);

/// Returns a vertex in clip space with the given w, or on a map, that the transform takes to (x, y)
/// or to a place a few roundings away.
///
/// Domain:     w positive and finite.
/// Returns:    doubles: callers that need float32 round them.
Vertex ToClip(const Vertex& window, double w, const Transform& transform, int width, int height);

/// Returns the scene with every vertex taken through the transform; in the transform's precision.
///
/// Domain:     a clip-space scene; with a map, a scene in the map's coordinates.
Scene ToWindow(const Scene& scene, const Transform& transform);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_TRANSFORM_H_
