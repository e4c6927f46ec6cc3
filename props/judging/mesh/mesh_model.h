// Exact facings and winding numbers of a mesh, in window space and around the eye.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_MESH_MODEL_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_MESH_MODEL_H_

#include <cstdint>
#include <vector>

#include "props/placed_case.h"

namespace rasterproof::props {

/// Which way a mesh's triangles face, after snapping. Clip space that does not snap: seen from the
/// eye, wherever they lie around it.
struct MeshFacings {
  bool folded = false;           ///< triangles of both facings
  std::uint64_t degenerate = 0;  ///< triangles of zero area: in clip space, in a plane with the eye
};
MeshFacings FacingsOf(const PlacedCase& c);

/// The winding number at every sample: of the boundary around it, and in clip space of the surface
/// around the eye along the sample's ray. Where all triangles face one way its size is the number
/// of triangles that cover the sample.
///
/// Shape:      as CoverageCounts.
/// Properties: a rule that gives no sample to one side counts as top-left.
std::vector<std::int64_t> WindingOf(const PlacedCase& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_MESH_MODEL_H_
