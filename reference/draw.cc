#include "reference/draw.h"

#include "core/error.h"

namespace rasterproof::reference {

void RequireWindowScene(const Scene& scene, const CoverageCounts& counts) {
  if (scene.clip_space) {
    throw InputError("scene " + scene.name, "its vertices are in clip space (x, y, z, w)",
                     "use a homogeneous method (hom-...)");
  }
  if (counts.width != scene.width || counts.height != scene.height || counts.samples != 1) {
    throw InputError("scene " + scene.name, "the counts do not have the target's shape",
                     "make them of the scene's width and height, one sample a pixel");
  }
}

}  // namespace rasterproof::reference
