// Coverage against the oracle, clip space.
#ifndef RASTERPROOF_PROPS_CATALOG_CLIP_COVERAGE_H_
#define RASTERPROOF_PROPS_CATALOG_CLIP_COVERAGE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Clip-space triangles, behind the eye or across it as they may be, cover what the ray through
/// the sample meets.
Verdict ClipSpaceCoverageEqualsTheModel(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CLIP_COVERAGE_H_
