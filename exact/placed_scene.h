// A scene where a profile's model puts it: worked out once, read by every decider.
#ifndef RASTERPROOF_EXACT_PLACED_SCENE_H_
#define RASTERPROOF_EXACT_PLACED_SCENE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "model/target_profile.h"

namespace rasterproof::exact {

/// A scene, the profile on its target, and where that puts the scene's triangles.
struct PlacedScene {
  PlacedScene(Scene given, const Profile& stated);

  Scene scene;  ///< as given
  TargetProfile profile;
  /// Why the vertices have no places: a clip-space scene under a profile that speaks of window
  /// space alone, or SnapClipError(). `placed` is then the scene as given.
  std::optional<InputError> why_not_placed;
  /// In window space; where clip space does not snap, the scene as given. Vertices and triangles
  /// keep their numbers; a triangle that is dropped for its extent has its corners in one place.
  Scene placed;
  /// Of each triangle, on screen: +1 front (counter-clockwise), -1 back, 0 where it has no area, is
  /// dropped or is not finite. Without a place in clip space: by its homogeneous area.
  std::vector<std::int8_t> facings;
  /// The finite triangles without area. One that is dropped for its extent has one all the same.
  std::vector<std::size_t> flat;

 private:
  void Place();
  void FindFacings();
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_PLACED_SCENE_H_
