// Triangles that share an edge, and the boundary that is left.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_MESH_NEIGHBOURS_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_MESH_NEIGHBOURS_H_

#include <array>
#include <cstddef>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Two triangles that traverse the same edge in opposite directions. Window space: by position
/// after snapping. Clip space: by (x, y, w) as given.
struct Neighbours {
  std::size_t first = 0;
  std::size_t second = 0;
  int edge = 0;         ///< of the first triangle: the one opposite this vertex
  int second_edge = 0;  ///< of the second
};

/// At most `limit` pairs, spread evenly, both of the same non-zero facing: so they lie on either
/// side of the edge, as the window shows them or around the eye.
std::vector<Neighbours> SharedEdges(const PlacedCase& c, std::size_t limit);

/// A directed edge of the boundary.
struct BoundaryEdge {
  Vertex a;
  Vertex b;
};

/// The directed edges of a mesh that no opposite edge cancels, by x, y and w as they are.
std::vector<BoundaryEdge> BoundaryOf(const Scene& scene);

/// Whether every directed edge is traversed as often as its reverse, by x, y and w as given.
/// Triangles that are not finite are left out.
bool IsClosed(const Scene& scene);

/// Start and end of edge `edge`, the one opposite vertex `edge`, in the triangle's direction.
inline const Vertex& EdgeStart(const std::array<Vertex, 3>& v, int edge) {
  return v[static_cast<std::size_t>((edge + 1) % 3)];
}
inline const Vertex& EdgeEnd(const std::array<Vertex, 3>& v, int edge) {
  return v[static_cast<std::size_t>((edge + 2) % 3)];
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_MESH_NEIGHBOURS_H_
