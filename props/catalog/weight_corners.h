// Weights at vertices and on edges.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_CORNERS_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_CORNERS_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Weight i is one at vertex i and zero at the other two and at samples exactly on the opposite
/// edge, up to the bound claimed there.
Verdict WeightIsOneAtItsVertexAndZeroOpposite(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_CORNERS_H_
