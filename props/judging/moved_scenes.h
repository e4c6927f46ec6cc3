// Scenes that differ from a case in a vertex, or in all of them, and cover something else.
#ifndef RASTERPROOF_PROPS_JUDGING_MOVED_SCENES_H_
#define RASTERPROOF_PROPS_JUDGING_MOVED_SCENES_H_

#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "legal/allowed.h"
#include "props/placed_case.h"

namespace rasterproof::props {

struct MovedScene {
  Scene scene;
  legal::Allowed expected;
  std::string change;  ///< completes "drawn after the case, with ..."
};

/// Returns why no moved scenes are looked for, or nothing if they are: the case has no triangle, or
/// moves cost more than they show.
std::optional<std::string> WhyNotMoved(const PlacedCase& c);

/// A move counts if no legal model of the case covers some sample as some legal model of the moved
/// scene does, and the profile says what that one covers.
class MovedScenes {
 public:
  /// Domain:     no WhyNotMoved; the case outlives this.
  MovedScenes(const PlacedCase& c, const legal::Sight& sight);

  /// What the case covers, if expected().why_not() is empty.
  const legal::Allowed& expected() const { return expected_; }
  /// For each of three distances, from small to large, the first move of one vertex of the first
  /// triangle that counts, if any does.
  std::vector<MovedScene> ByOneVertex() const;
  /// The first move that counts, if any does, of one vertex of the first triangle that shares none
  /// with triangle 0: size, indices and triangle 0 stay.
  std::optional<MovedScene> BehindTheFirst() const;
  /// Other vertices under the same indices, as many: x and y exchanged, or the list turned round.
  std::optional<MovedScene> OtherContent() const;

 private:
  std::optional<MovedScene> FirstThatDiffers(const Triangle& triangle, double pixels,
                                             const char* words) const;
  std::optional<MovedScene> IfItDiffers(Scene scene, const std::string& change) const;

  const PlacedCase& c_;
  legal::Sight sight_;
  legal::Allowed expected_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MOVED_SCENES_H_
