#include "reference/rasterize.h"

#include <string>

#include "core/error.h"

namespace rasterproof::reference {

void RequireTakes(const Scene& scene, const Method& method) {
  const std::string place = "scene " + scene.name;
  if (scene.clip_space && !method.info.takes_clip) {
    throw InputError(
        place,
        "its vertices are in clip space, and " + method.info.name + " draws window space only",
        "use a homogeneous method (hom-...)");
  }
  if (!scene.clip_space && !method.info.takes_window) {
    throw InputError(place, method.info.name + " draws clip space only",
                     "use a window-space method (spans-exact, f32-...)");
  }
  if (!Takes(method.info, scene)) {
    throw InputError(
        place, "its coordinates are float64, and " + method.info.name + " computes in float32",
        "use a method with float64 input (spans-exact, f64-...)");
  }
}

void Rasterize(const Scene& scene, const Method& method, const RasterOptions& options,
               CoverageCounts& counts) {
  RequireTakes(scene, method);
  method.draw(scene, options, counts);
}

}  // namespace rasterproof::reference
