// Edge values of a scene enlarged.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_SCALING_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_SCALING_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Enlarging edge and sample by 2^k multiplies E by 4^k, where the results are on the input
/// lattice.
Verdict PowerOfTwoScalingScalesEdgeValues(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_SCALING_H_
