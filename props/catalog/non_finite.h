// NaN and infinity.
#ifndef RASTERPROOF_PROPS_CATALOG_NON_FINITE_H_
#define RASTERPROOF_PROPS_CATALOG_NON_FINITE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A triangle with a NaN or infinite x, y or w covers nothing.
Verdict NonFiniteTrianglesCoverNothing(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_NON_FINITE_H_
