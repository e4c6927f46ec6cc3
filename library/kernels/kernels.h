// The table of one target.
#ifndef RASTERPROOF_LIBRARY_KERNELS_KERNELS_H_
#define RASTERPROOF_LIBRARY_KERNELS_KERNELS_H_

#include "core/own_precision.h"
#include "library/kernels/clip_rows.h"
#include "library/kernels/exact_spans.h"
#include "library/kernels/fill.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/known_spans.h"
#include "library/kernels/sinks.h"
#include "library/kernels/span_sink.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

// A template of functions is no template argument: a row for each method, by its name.
// NOLINTBEGIN(bugprone-macro-parentheses): of a template's name there are none.
#define RASTERPROOF_KERNEL_ROW(Draw)                                                          \
  {&Draw<PixelSink<Count8>>, &Draw<PixelSink<Facing>>, &Draw<MaskSink>, &Draw<PixelSink<Id>>, \
   &Draw<PixelSink<Depth>>}
// NOLINTEND(bugprone-macro-parentheses)

constexpr KernelTable kKernels = {
    RASTERPROOF_KERNEL_ROW(DrawExact),
    {&FillCount8, &FillFacing, &FillMask, &FillId, &FillDepth},
    &DrawExact<SpanSink>,
    {&DrawClip<PixelSink<Count8>>, &DrawClip<PixelSink<Facing>>, &DrawClip<MaskSink>,
     &DrawClip<PixelSink<Id>>, &DrawClip<PixelSink<ClipDepth>>},
    &DrawClip<SpanSink>,
    RASTERPROOF_KERNEL_ROW(DrawKnown),
};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_KERNELS_H_
