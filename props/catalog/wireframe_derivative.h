// The wireframe test by screen derivatives.
#ifndef RASTERPROOF_PROPS_CATALOG_WIREFRAME_DERIVATIVE_H_
#define RASTERPROOF_PROPS_CATALOG_WIREFRAME_DERIVATIVE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Dividing by |d lambda/dx| + |d lambda/dy| measures pixels in the L1 norm of the gradient:
/// between 1/sqrt(2) of the distance (diagonal edges) and the distance (edges along an axis).
Verdict DerivativeDistanceMeasuresInTheL1Norm(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WIREFRAME_DERIVATIVE_H_
