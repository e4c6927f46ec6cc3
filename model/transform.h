// The stage from clip space, or from a map, to window space as a rasterizer computes it, operation
// by operation.
#ifndef RASTERPROOF_MODEL_TRANSFORM_H_
#define RASTERPROOF_MODEL_TRANSFORM_H_

#include "core/scene.h"
#include "core/transform.h"
#include "core/vertex.h"

namespace rasterproof {

/// Returns the window-space vertex that the transform makes of a clip-space one, or of a map's.
///
/// Domain:     any vertex; the target's size within a scene's limits.
/// Returns:    x and y bit for bit as the operations give them, infinities and NaN included; NaN if
///             the vertex is not finite or w is not positive: what clipping makes of it is not the
///             transform's to say. z is that of the vertex, w is 1. A map has no w: it is not read.
Vertex ToWindow(const Vertex& clip, const Transform& transform, int width, int height);

/// Returns a clip-space vertex with the given w, or a map's, that the transform takes to (x, y), or
/// to a place a few roundings beside it.
///
/// Domain:     w positive and finite.
/// Returns:    doubles: a taker of float32 is to round them.
Vertex ToClip(const Vertex& window, double w, const Transform& transform, int width, int height);

/// Returns the scene with every vertex taken through the transform; in the transform's precision.
///
/// Domain:     a clip-space scene; behind a map, one of the map's coordinates.
Scene ToWindow(const Scene& scene, const Transform& transform);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_TRANSFORM_H_
