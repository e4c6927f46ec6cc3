// Drift over a walk of up to 16384 steps.
#ifndef RASTERPROOF_PROPS_CATALOG_WALK_LONG_H_
#define RASTERPROOF_PROPS_CATALOG_WALK_LONG_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A walk across the largest target drifts no further than the bound claimed for it.
Verdict LongWalkStaysWithinItsBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WALK_LONG_H_
