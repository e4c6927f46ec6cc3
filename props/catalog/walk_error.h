// Stepping instead of evaluating afresh.
#ifndef RASTERPROOF_PROPS_CATALOG_WALK_ERROR_H_
#define RASTERPROOF_PROPS_CATALOG_WALK_ERROR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Each of the eight walks (along x or y, either way, by one pixel or by L) meets values within
/// the bound that the subject claims for that many steps.
Verdict WalkStaysWithinItsBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WALK_ERROR_H_
