// A fragment's weights.
#ifndef RASTERPROOF_PROPS_CATALOG_FRAGMENT_WEIGHTS_H_
#define RASTERPROOF_PROPS_CATALOG_FRAGMENT_WEIGHTS_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Every weight at a covered sample is near the exact barycentric coordinate of the winner's
/// vertices that the subject declares, given or snapped.
Verdict FragmentWeightsStayWithinTheirError(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_FRAGMENT_WEIGHTS_H_
