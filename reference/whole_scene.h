// Whole scenes drawn at once by the vectorised kernels, for those who count samples.
#ifndef RASTERPROOF_REFERENCE_WHOLE_SCENE_H_
#define RASTERPROOF_REFERENCE_WHOLE_SCENE_H_

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"

namespace rasterproof::reference {

/// Returns whether the kernels take the scene: window space, and no coordinate that float32 rounds.
bool KernelsTake(const Scene& scene);

/// Returns whether the kernel of clip space takes it: as above, w too.
bool ClipKernelTakes(const Scene& scene);

/// Returns whether a kernel repays the separate surface that it draws on: with some dozens of
/// triangles, and not many pixels for each. It is measured by `rasterproof plan --measure`, in
/// window space.
bool KernelsPay(const Scene& scene);

/// Adds the scene's coverage by the exact kernel to `counts`, by the machine's widest vectors: the
/// counts are those of every target. Triangles with a NaN or an infinity cover nothing.
///
/// Domain:     KernelsTake(scene); counts of the scene's size, one sample a pixel.
void DrawByKernel(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

/// The same by what kernels are measured against.
///
/// Domain:     as DrawByKernel; not of Traversal::kMaskTiles, which keeps no facings.
void DrawByRival(const library::rivals::Rival& rival, const Scene& scene,
                 const DrawOptions& options, CoverageCounts& counts);

/// The same by the kernel of clip space, without a near plane.
///
/// Domain:     ClipKernelTakes(scene); counts of the scene's size, one sample a pixel.
void DrawByClipKernel(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_WHOLE_SCENE_H_
