// Weights of reordered vertices.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_PERMUTATION_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_PERMUTATION_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Reordering the vertices reorders the weights, up to the bounds claimed for both orders.
Verdict WeightsFollowTheirVertices(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_PERMUTATION_H_
