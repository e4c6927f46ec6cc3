// The error of interpolated values.
#ifndef RASTERPROOF_PROPS_CATALOG_INTERPOLATION_ERROR_H_
#define RASTERPROOF_PROPS_CATALOG_INTERPOLATION_ERROR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Interpolation by weights and by deltas stays within the bound claimed of the exact value.
Verdict InterpolationStaysWithinItsBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_INTERPOLATION_ERROR_H_
