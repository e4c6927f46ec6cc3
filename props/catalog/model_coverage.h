// Coverage against the oracle, window space.
#ifndef RASTERPROOF_PROPS_CATALOG_MODEL_COVERAGE_H_
#define RASTERPROOF_PROPS_CATALOG_MODEL_COVERAGE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Front and back counts equal those of the profile's canonical model at every sample.
Verdict CoverageEqualsTheModel(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_MODEL_COVERAGE_H_
