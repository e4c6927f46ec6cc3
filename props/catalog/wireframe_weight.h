// The wireframe test in weight space.
#ifndef RASTERPROOF_PROPS_CATALOG_WIREFRAME_WEIGHT_H_
#define RASTERPROOF_PROPS_CATALOG_WIREFRAME_WEIGHT_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The weight-space distance to an edge is lambda_i: a width W draws a line that is W times the
/// triangle's height wide, not W pixels.
Verdict WeightDistanceIsTheSmallestWeight(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WIREFRAME_WEIGHT_H_
