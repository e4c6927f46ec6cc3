// Front counts minus back counts.
#ifndef RASTERPROOF_PROPS_CATALOG_WINDING_NUMBER_H_
#define RASTERPROOF_PROPS_CATALOG_WINDING_NUMBER_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// For any triangles, folded or not, front minus back equals the winding number of the boundary
/// around the sample.
Verdict SignedCoverageEqualsTheWindingNumber(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WINDING_NUMBER_H_
