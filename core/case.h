// The input of a property: a value that can be saved, replayed and shrunk.
#ifndef RASTERPROOF_CORE_CASE_H_
#define RASTERPROOF_CORE_CASE_H_

#include <string>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// A scene with its target's size, the profile it is judged by, and the options it is drawn with.
struct Case {
  Scene scene;
  Profile profile;
  DrawOptions options;
  /// Where it came from: the name of a drawn case, "needles:17@1", or a file. One property goes by
  /// a drawn case's number: LargeTargetIsCoveredLikeASmallOne, which draws scenes of its own.
  std::string origin;

  friend bool operator==(const Case&, const Case&) = default;
};

/// The draw of a property that changes its case's scene.
struct DrawnScene {
  Scene scene;
  DrawOptions options;

  friend bool operator==(const DrawnScene&, const DrawnScene&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CASE_H_
