// The table of one target, in the order of kRivals.
#ifndef RASTERPROOF_LIBRARY_RIVALS_RIVALS_H_
#define RASTERPROOF_LIBRARY_RIVALS_RIVALS_H_

#include "core/own_precision.h"
#include "library/kernels/exact_spans.h"
#include "library/kernels/sinks.h"
#include "library/kernels/vectors.h"
#include "library/rivals/fixed_spans.h"
#include "library/rivals/fixed_tiles.h"
#include "library/rivals/homogeneous.h"
#include "library/rivals/incremental.h"
#include "library/rivals/mask_rows.h"
#include "library/rivals/rival_table.h"
#include "library/rivals/spans.h"
#include "library/rivals/tiles.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

// A template of functions is no template argument: rows by macros.
// NOLINTBEGIN(bugprone-macro-parentheses): of a template's name and its arguments there are none.
#define RASTERPROOF_RIVAL_ROW(Draw, ...) \
  {nullptr, &Draw<__VA_ARGS__ PixelSink<Facing>>, &Draw<__VA_ARGS__ MaskSink>, nullptr, nullptr}
#define RASTERPROOF_FULL_RIVAL_ROW(Draw, ...)                                  \
  {&Draw<__VA_ARGS__ PixelSink<Count8>>, &Draw<__VA_ARGS__ PixelSink<Facing>>, \
   &Draw<__VA_ARGS__ MaskSink>, &Draw<__VA_ARGS__ PixelSink<Id>>,              \
   &Draw<__VA_ARGS__ PixelSink<Depth>>}
// NOLINTEND(bugprone-macro-parentheses)

constexpr rivals::RivalTable kRivalKernels = {
    {
        RASTERPROOF_FULL_RIVAL_ROW(DrawExactUnsafe, ),
        RASTERPROOF_RIVAL_ROW(DrawIncremental, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, float, Form::kDirect, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, float, Form::kAffine, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, float, Form::kStepped, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, double, Form::kDirect, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, double, Form::kAffine, ),
        RASTERPROOF_RIVAL_ROW(DrawTiles, double, Form::kStepped, ),
        RASTERPROOF_RIVAL_ROW(DrawFixedTiles, true, ),
        RASTERPROOF_RIVAL_ROW(DrawFixedTiles, false, ),
        RASTERPROOF_FULL_RIVAL_ROW(DrawSpans, float, Form::kDirect, ),
        RASTERPROOF_RIVAL_ROW(DrawSpans, float, Form::kAffine, ),
        RASTERPROOF_RIVAL_ROW(DrawSpans, float, Form::kStepped, ),
        RASTERPROOF_FULL_RIVAL_ROW(DrawSpans, double, Form::kDirect, ),
        RASTERPROOF_RIVAL_ROW(DrawSpans, double, Form::kAffine, ),
        RASTERPROOF_RIVAL_ROW(DrawSpans, double, Form::kStepped, ),
        RASTERPROOF_RIVAL_ROW(DrawFixedSpans, ),
        {nullptr, nullptr, &DrawMaskRows, nullptr, nullptr},
    },
    {nullptr, &DrawHomogeneous<PixelSink<Facing>>, &DrawHomogeneous<MaskSink>, nullptr, nullptr}};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_RIVALS_H_
