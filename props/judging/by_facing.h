// The triangles of a scene by the way they face.
#ifndef RASTERPROOF_PROPS_JUDGING_BY_FACING_H_
#define RASTERPROOF_PROPS_JUDGING_BY_FACING_H_

#include <cstddef>
#include <vector>

#include "core/scene.h"
#include "exact/placed_scene.h"

namespace rasterproof::props {

/// Triangles of one scene, each list in the order given.
struct TrianglesByFacing {
  std::vector<Triangle> front;  ///< includes triangles without area: they should cover nothing
  std::vector<Triangle> back;

  /// By the canonical model. Where the profile leaves other models legal that is a guess
  /// (OpenTriangles).
  explicit TrianglesByFacing(const exact::PlacedScene& scene) {
    for (std::size_t t = 0; t < scene.facings.size(); ++t) {
      (scene.facings[t] < 0 ? back : front).push_back(scene.scene.triangles[t]);
    }
  }
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_BY_FACING_H_
