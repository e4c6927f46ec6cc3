// The sign of a division-free edge.
#ifndef RASTERPROOF_PROPS_CATALOG_CLIP_SCALING_H_
#define RASTERPROOF_PROPS_CATALOG_CLIP_SCALING_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Multiplying x, y and w of a clip-space vertex by a positive power of two changes no sign and so
/// no sample: the edges V_j x V_i are only multiplied by it.
Verdict ScalingClipVerticesKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CLIP_SCALING_H_
