// An embedded triangle mesh that grows by splitting.
#ifndef RASTERPROOF_PROPS_DOMAINS_PLANAR_MESH_H_
#define RASTERPROOF_PROPS_DOMAINS_PLANAR_MESH_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vertex.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"

namespace rasterproof::props {

/// Triangles of one facing that overlap nowhere. Splits keep it so, by exact signs.
///
/// Domain:     vertices on the lattice of the builder that it is added to, so that nothing moves.
struct PlanarMesh {
  std::vector<Point2> vertices;
  std::vector<Triangle> triangles;

  std::int32_t AddVertex(Point2 p);
  /// Splits the triangles that contain p, in their inside (three parts) or on an edge (two parts of
  /// each side). Does nothing if p is a vertex or outside.
  void Insert(Point2 p);
  /// Splits edge `edge` (opposite its vertex `edge`) of triangle t at p, and leaves the neighbour
  /// across that edge as it is: a T-junction, with a gap or an overlap if p is not on the edge.
  void SplitOneSide(std::size_t t, std::size_t edge, Point2 p);
  /// Adds two triangles for each cell of a grid whose nodes are the vertices, row by row; their
  /// diagonal goes either way. Draws a choice a cell.
  void AddCells(BitSource& bits, int columns, int rows);
  /// Whether every triangle has the same facing as the first, and none has zero area.
  bool IsFacingOneWay() const;
  void AddTo(CaseBuilder& builder) const;

 private:
  // Signs of p against the edges 12, 20, 01 of triangle t, positive inside.
  std::array<int, 3> Sides(std::size_t t, Point2 p) const;
  void Split(std::size_t t, const std::array<int, 3>& sides, std::int32_t p);
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_PLANAR_MESH_H_
