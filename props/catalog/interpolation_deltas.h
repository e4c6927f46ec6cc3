// Two ways to interpolate.
#ifndef RASTERPROOF_PROPS_CATALOG_INTERPOLATION_DELTAS_H_
#define RASTERPROOF_PROPS_CATALOG_INTERPOLATION_DELTAS_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// z0 + l1 (z1 - z0) + l2 (z2 - z0) and l0 z0 + l1 z1 + l2 z2 agree up to the sum of their bounds.
Verdict DepthByDeltasEqualsDepthByWeights(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_INTERPOLATION_DELTAS_H_
