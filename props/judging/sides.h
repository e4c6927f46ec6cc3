// The triangles of a scene by the way they face.
#ifndef RASTERPROOF_PROPS_JUDGING_SIDES_H_
#define RASTERPROOF_PROPS_JUDGING_SIDES_H_

#include <span>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::props {

/// Triangles of one scene, each list in the order given.
struct Sides {
  std::vector<Triangle> front;  ///< and those without area: they should cover nothing
  std::vector<Triangle> back;
};

/// The triangles by their facing under the canonical model of the profile: in clip space by their
/// quotients on its grid, or as given where there is no grid. Where the profile leaves other models
/// legal that is a guess (OpenTriangles).
///
/// Domain:     triangles of the scene's vertices.
Sides SidesOf(const Scene& scene, std::span<const Triangle> triangles, const Profile& profile);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_SIDES_H_
