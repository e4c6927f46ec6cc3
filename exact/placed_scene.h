// A scene with its vertices where a profile's model places them: computed once for every decider.
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

/// A scene, its profile for its target, and the places of its triangles under that profile.
struct PlacedScene {
  PlacedScene(Scene given, const Profile& stated);

  Scene scene;  ///< as given
  TargetProfile profile;
  /// Why the vertices have no places: the profile is about window space alone and the scene is in
  /// clip space, or SnapClipError(). `placed` is then the given scene.
  std::optional<InputError> why_not_placed;
  /// The scene in window space, or the given scene if its clip space is not snapped. Vertices and
  /// triangles keep their numbers; a triangle dropped for its extent or its facing is collapsed to
  /// one place.
  Scene placed;
  /// Each triangle's facing on screen: +1 front (counter-clockwise), -1 back, 0 if it has no area,
  /// is dropped, is always culled or is not finite. A triangle of clip space without a place has
  /// the sign of its homogeneous area.
  std::vector<std::int8_t> facings;
  /// The finite triangles without area. Those dropped for their extent alone are not among them.
  std::vector<std::size_t> flat;
  /// The triangles of the side that the profile always culls.
  std::vector<std::size_t> culled;

 private:
  void Place();
  void FindFacings();
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_PLACED_SCENE_H_
