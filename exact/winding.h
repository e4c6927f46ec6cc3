// Winding numbers of a mesh's boundary, which signed coverage must equal.
#ifndef RASTERPROOF_EXACT_WINDING_H_
#define RASTERPROOF_EXACT_WINDING_H_

#include <cstdint>
#include <vector>

#include "exact/placed_scene.h"

namespace rasterproof::exact {

/// Returns the winding number of the mesh's boundary around each (shifted) sample, positive if
/// counter-clockwise on screen.
///
/// The boundary consists of the placed scene's directed edges (keyed by position bits, not by
/// index) that remain after opposite pairs cancel. Triangles with a non-finite vertex or dropped
/// for their extent are left out. The inclusive and the exclusive rule, which no shift of a sample
/// expresses, count as top-left.
/// Shape:      as CoverageCounts.
/// Error:      none; throws InputError for a scene that is placed in clip space.
/// Properties: equals the signed coverage, docs/mathematics.md.
std::vector<std::int64_t> BoundaryWinding(const PlacedScene& scene);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_WINDING_H_
