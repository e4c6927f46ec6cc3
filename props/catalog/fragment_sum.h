// The sum of a fragment's weights.
#ifndef RASTERPROOF_PROPS_CATALOG_FRAGMENT_SUM_H_
#define RASTERPROOF_PROPS_CATALOG_FRAGMENT_SUM_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The weights at a covered sample sum to one.
Verdict FragmentWeightsSumToOne(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_FRAGMENT_SUM_H_
