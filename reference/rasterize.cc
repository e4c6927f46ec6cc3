#include "reference/rasterize.h"

#include <string>

#include "core/error.h"

namespace rasterproof::reference {

void Rasterize(const Scene& scene, const Method& method, const RasterOptions& options,
               CoverageCounts& counts) {
  if (!scene.clip_space && !method.info.takes_window) {
    throw InputError("scene " + scene.name, method.info.name + " draws clip space only",
                     "use a window-space method");
  }
  if (scene.precision == Precision::kFloat64 && method.info.input == Precision::kFloat32) {
    throw InputError("scene " + scene.name,
                     "its coordinates are float64 and " + method.info.name + " computes in float32",
                     "use a method with float64 input (f64-..., spans-exact)");
  }
  method.draw(scene, options, counts);
}

}  // namespace rasterproof::reference
