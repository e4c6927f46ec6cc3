// Interpolated values and their extremes.
#ifndef RASTERPROOF_PROPS_CATALOG_INTERPOLATION_HULL_H_
#define RASTERPROOF_PROPS_CATALOG_INTERPOLATION_HULL_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Inside the closed triangle a value interpolated with positive w lies between the least and the
/// greatest vertex value, up to the bound claimed.
Verdict InterpolatedValuesStayInTheHull(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_INTERPOLATION_HULL_H_
