#include "reference/rasterize.h"

#include <optional>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/float_environment.h"
#include "reference/bands.h"
#include "reference/box.h"

namespace rasterproof::reference {
namespace {

bool IsCulled(int facing, Cull cull) { return cull == (facing > 0 ? Cull::kFront : Cull::kBack); }

void RequireShape(const Scene& scene, const CoverageCounts& counts) {
  if (counts.width == scene.width && counts.height == scene.height && counts.samples == 1) return;
  throw InputError("scene " + scene.name, "the counts do not have the target's shape",
                   "make them of the scene's width and height, one sample a pixel");
}

}  // namespace

void Rasterize(const Scene& scene, const Method& method, const RasterOptions& options,
               CoverageCounts& counts) {
  RequireTakes(scene, method);
  RequireShape(scene, counts);
  // A method that states exact results keeps to it in whatever mode its caller left.
  std::optional<FloatEnvironment> sane;
  if (method.info.states_exact) sane.emplace();
  if (method.whole != nullptr && method.whole(scene, options, counts)) return;
  const Stages& stage = method.stages;
  const PixelRect target = TargetOf(scene);
  // Threads draw bands of rows; no two share a row, so their order can't be seen.
  ForEachBand(DrawArea(scene, options), options, [&](const PixelRect& band) {
    for (const Triangle& t : scene.triangles) {
      // Place the vertices: as given, on the method's grid, or divided by w.
      std::optional<Corners3> v = stage.place(Corners(scene, t));
      if (!v) continue;
      // Bound the samples: beyond this box E is negative for one of the edges.
      const PixelRect box = stage.box(*v, target);
      const PixelRect area = Intersection(box, band);
      if (IsEmpty(area)) continue;
      // Find the facing, the sign of E(v0, v1; v2), and cull by it.
      const int facing = stage.facing(*v, options);
      if (facing == 0 || IsCulled(facing, options.cull)) continue;
      // Orient the triangle: counter-clockwise on screen, E is positive inside of each edge.
      if (facing < 0) std::swap((*v)[1], (*v)[2]);
      // Evaluate the edges over the area; count each sample inside all three, ties by the rule.
      stage.fill(*v, options,
                 {box, area, (facing > 0 ? counts.front : counts.back).data(), counts.width});
    }
  });
}

void RequireTakes(const Scene& scene, const Method& method) {
  if (Takes(method.info, scene)) return;
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
  throw InputError(place,
                   "its coordinates are float64, and " + method.info.name + " computes in float32",
                   "use a method with float64 input (spans-exact, f64-...)");
}

}  // namespace rasterproof::reference
