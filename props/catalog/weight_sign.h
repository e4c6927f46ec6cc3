// The signs of the weights.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_SIGN_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_SIGN_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A weight has the sign of its exact lambda wherever |lambda| exceeds the bound claimed: a sample
/// inside gets no negative weight, one outside gets one.
Verdict WeightSignsAgreeWithTheEdges(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_SIGN_H_
