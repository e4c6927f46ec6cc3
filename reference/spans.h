// Exact row spans: one decision per edge and row, none per pixel.
#ifndef RASTERPROOF_REFERENCE_SPANS_H_
#define RASTERPROOF_REFERENCE_SPANS_H_

#include "reference/method.h"

namespace rasterproof::reference {

/// The facing and fill stages of exact spans.
///
/// Domain:     finite vertices, fill in either winding.
/// Error:      none: sample-exact for every finite double, top-left.
int ExactFacing(const Corners3& v, const RasterOptions& options);
void FillSpans(const Corners3& v, const RasterOptions& options, const FillTarget& to);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_SPANS_H_
