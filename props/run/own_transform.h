// Subjects that own the transform from clip space, or from a map, to window space.
//
// Such a subject is given clip space, or a map's coordinates, and held to what its transform,
// computed operation by operation, makes of it. Properties see a window-space subject and the
// transformed case: all that is stated of window space holds for it.
#ifndef RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_
#define RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/case.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::props {

class BitSource;

/// Returns whether the subject takes clip space, or a map, through its own transform.
inline bool OwnsTransform(const SubjectInfo& info) {
  const auto& transform = info.profile.transform;
  return transform && (transform->map ? info.takes_window : info.takes_clip);
}

/// What recipes draw for the subject: itself, or for an owner of a transform a taker of window
/// space in the transform's precision.
SubjectInfo AsSeenByRecipes(const SubjectInfo& info);

/// The case with every vertex in clip space, or on the map, so that the transform takes it back to
/// its place, or some roundings beside it. Vertices of one place stay at one place.
Case PutBehindTransform(Case window, const SubjectInfo& info, BitSource& bits);

/// The case as properties see it: after the profile's transform, if it takes the scene.
Case SeenCase(const Case& c);

/// A place in window space by its bits: NaN is a place as well, and -0 is not +0.
using PlaceBits = std::array<std::uint64_t, 2>;

/// The places that a subject's own transform takes the vertices of a scene to.
class PlacesOfTransform {
 public:
  /// Domain:     the window-space scene that the transform makes of the given one.
  PlacesOfTransform(const Scene& given, const Scene& window);

  /// The scene with the vertices that the transform takes to where its own lie.
  ///
  /// Returns:    nothing if a vertex has no such place, or the target is another one (WhyNot).
  std::optional<Scene> AsGiven(const Scene& window) const;
  /// Why AsGiven gave nothing for the scene.
  std::string WhyNot(const Scene& window) const;

 private:
  bool IsOfTheTarget(const Scene& window) const;

  int width_;
  int height_;
  Precision precision_;
  bool clip_space_;
  std::map<PlaceBits, Vertex> given_of_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_OWN_TRANSFORM_H_
