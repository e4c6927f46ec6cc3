// Perspective-correct interpolation.
#ifndef RASTERPROOF_PROPS_CATALOG_INTERPOLATION_PERSPECTIVE_H_
#define RASTERPROOF_PROPS_CATALOG_INTERPOLATION_PERSPECTIVE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Perspective-correct interpolation stays within the bound claimed of the exact quotient; with
/// one w for all vertices that is the affine value.
Verdict PerspectiveInterpolationStaysWithinItsBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_INTERPOLATION_PERSPECTIVE_H_
