// The point that the weights stand for.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_POINT_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_POINT_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The weighted sum of the vertices is the sample, up to the weights' bounds times the
/// coordinates.
Verdict WeightsReproduceThePoint(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_POINT_H_
