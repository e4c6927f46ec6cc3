// The neighbourhood of a mesh's outline, where what it covers is not always promised.
#ifndef RASTERPROOF_PROPS_CATALOG_OUTLINE_H_
#define RASTERPROOF_PROPS_CATALOG_OUTLINE_H_

#include <vector>

#include "core/case.h"
#include "core/vertex.h"
#include "props/catalog/mesh_neighbours.h"

namespace rasterproof::props {

/// The samples beside the boundary of a window-space mesh.
class Outline {
 public:
  /// No outline: nothing is near.
  Outline() = default;
  /// `may_move`: the subject may have moved the boundary by up to a pixel, by snapping its vertices
  /// to a grid of its own or by clipping it.
  Outline(const Case& c, bool may_move);

  bool IsNear(Point2 p) const;
  bool IsEmpty() const { return boundary_.empty(); }

 private:
  std::vector<BoundaryEdge> boundary_;
  double margin_ = 0;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_OUTLINE_H_
