// The library's drawing, without its checks.
#ifndef RASTERPROOF_LIBRARY_DRAW_H_
#define RASTERPROOF_LIBRARY_DRAW_H_

#include <functional>

#include "library/kernels/kernel.h"
#include "library/kernels/kernel_table.h"
#include "library/rasterize.h"

namespace rasterproof::library {

/// Whether memory (and back) has RoomFor(target) bytes, so that Draw allocates nothing.
bool HasRoom(const RasterTarget& target);

/// Draws onto the contents of the target's memory, in whatever floating-point environment.
///
/// Domain:     what RequireAllButIndices and RequireIndices take, and no output of squares.
void Draw(const RasterMesh& mesh, const RasterTarget& target, library::kernels::Target simd);

/// Calls on_span(state, span) with what the mesh covers, as Rasterize does its function.
///
/// Domain:     a sane floating-point environment.
void DrawSpans(const RasterMesh& mesh, int width, int height, library::kernels::Target simd,
               void (*on_span)(const void* state, const library::kernels::KernelSpan& span),
               const void* state);

/// Values of spans: calls for_each_span(on_span, state), which calls on_span(state, span) with what
/// the mesh covers, triangle by triangle.
///
/// Domain:     what RasterizeValues takes; a sane floating-point environment.
void DrawValues(const RasterMesh& mesh, const RasterValues& values, kernels::Target simd,
                const std::function<void(void (*on_span)(const void*, const kernels::KernelSpan&),
                                         const void* state)>& for_each_span);

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_DRAW_H_
