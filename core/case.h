// The input of a property: a value that can be saved, replayed and shrunk.
#ifndef RASTERPROOF_CORE_CASE_H_
#define RASTERPROOF_CORE_CASE_H_

#include <cstdint>
#include <optional>
#include <string>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// The name of a drawn case: "near-edge:17@1" is case 17 of the domain near-edge under seed 1. It
/// determines the case together with the subject's input lattice and profile; neither the property
/// nor the other domains matter.
struct CaseName {
  std::string domain;
  std::uint64_t index = 0;
  std::uint64_t seed = 1;

  friend bool operator==(const CaseName&, const CaseName&) = default;
};

/// A scene with its target's size, the profile it is judged by, and the options it is drawn with.
struct Case {
  Scene scene;
  Profile profile;
  DrawOptions options;
  /// Where it came from, for readers: the name of a drawn case, "needles:17@1", or a file.
  std::string origin;
  /// The name under which a domain or a world drew it, and what it was before it was shrunk. A
  /// property whose draws are dear makes them for few of the drawn cases, by their numbers; for a
  /// case without a name, as from a file, it makes them all.
  std::optional<CaseName> name = std::nullopt;

  /// Whether both are the same scene and origin, judged and drawn the same way.
  friend bool operator==(const Case& a, const Case& b) {
    return a.scene == b.scene && a.profile == b.profile && a.options == b.options &&
           a.origin == b.origin;
  }
};

/// The draw of a property that changes its case's scene.
struct DrawnScene {
  Scene scene;
  DrawOptions options;

  friend bool operator==(const DrawnScene&, const DrawnScene&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CASE_H_
