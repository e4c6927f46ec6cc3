// The reference rasterizer's front door.
#ifndef RASTERPROOF_REFERENCE_RASTERIZE_H_
#define RASTERPROOF_REFERENCE_RASTERIZE_H_

#include "core/coverage.h"
#include "core/fragments.h"
#include "core/scene.h"
#include "reference/method.h"

namespace rasterproof::reference {

/// Throws InputError, naming the remedy, unless Takes(method.info, scene).
void RequireTakes(const Scene& scene, const Method& method);

/// Adds the scene's coverage by `method` to `counts`.
///
/// Domain:     a scene that Takes(method.info, scene); counts of the scene's size, with one sample
///             a pixel: no method draws more.
/// Properties: the caller's rounding mode and the like change nothing of a method that states exact
///             results; of others they do.
/// Error:      InputError if the scene or the counts are others.
void Rasterize(const Scene& scene, const Method& method, const RasterOptions& options,
               CoverageCounts& counts);

/// What else a caller may ask for. What is not asked for is compiled out of the kernel that runs.
struct Needs {
  bool barycentrics = false;
  bool depth = false;
  bool edge_distance = false;
};

/// Draws the nearest triangle at each pixel centre (smallest interpolated z; no blending), coverage
/// by `method`.
///
/// Returns:    buffers of the scene's size; those not needed are empty (`triangle` is always
/// filled).
FragmentBuffers RasterizeFragments(const Scene& scene, const Method& method,
                                   const RasterOptions& options, const Needs& needs);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_RASTERIZE_H_
