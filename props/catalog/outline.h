// The neighbourhood of a mesh's outline, where what it covers is not always promised.
#ifndef RASTERPROOF_PROPS_CATALOG_OUTLINE_H_
#define RASTERPROOF_PROPS_CATALOG_OUTLINE_H_

#include <vector>

#include "core/case.h"
#include "core/vertex.h"
#include "props/catalog/mesh_neighbours.h"
#include "props/catalog/visible_edge.h"

namespace rasterproof::props {

/// How far a subject may have moved a vertex, in pixels, where its profile does not say how far: a
/// pixel is generous for a grid of its own, or for clipping.
inline constexpr double kMovedOutlineMargin = 1;

/// The samples beside some edges of a mesh: those of its boundary, or all.
class Outline {
 public:
  /// No outline: nothing is near.
  Outline() = default;
  /// The boundary. `may_move`: the subject may have moved it by up to a pixel, by snapping its
  /// vertices to a grid of its own or by clipping it.
  Outline(const Case& c, bool may_move);
  /// Every edge of every triangle.
  static Outline OfAllEdges(const Case& c, bool may_move);

  bool IsNear(Point2 p) const;
  bool IsEmpty() const { return edges_.empty(); }

 private:
  struct Edge {
    VisibleEdge seen;
    double margin = 0;
  };

  void Add(const Case& c, const BoundaryEdge& edge, double moved);

  std::vector<Edge> edges_;
  double largest_ = 0;  ///< window coordinate
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_OUTLINE_H_
