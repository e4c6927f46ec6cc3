// Triangles that share an edge, and the boundary that is left.
#ifndef RASTERPROOF_PROPS_CATALOG_MESH_NEIGHBOURS_H_
#define RASTERPROOF_PROPS_CATALOG_MESH_NEIGHBOURS_H_

#include <cstddef>
#include <vector>

#include "core/case.h"
#include "core/vertex.h"

namespace rasterproof::props {

/// Two triangles that walk the same edge in opposite directions, by position after snapping.
struct Neighbours {
  std::size_t first = 0;
  std::size_t second = 0;
  int edge = 0;  ///< of the first triangle: the one opposite this vertex
  Point2 a;      ///< its ends
  Point2 b;
};

/// At most `limit` pairs, spread evenly. Window space: both of the same non-zero facing, so that
/// they lie on either side of the edge. Clip space: positions are (x, y, w); a and b are not set.
std::vector<Neighbours> SharedEdges(const Case& c, std::size_t limit);

/// A directed edge of the boundary.
struct BoundaryEdge {
  Point2 a;
  Point2 b;
};

/// The directed edges of a window-space mesh that no opposite edge cancels, by position as it is.
std::vector<BoundaryEdge> BoundaryOf(const Scene& scene);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_MESH_NEIGHBOURS_H_
