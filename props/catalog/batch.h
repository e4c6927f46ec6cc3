// Several scenes in one call.
#ifndef RASTERPROOF_PROPS_CATALOG_BATCH_H_
#define RASTERPROOF_PROPS_CATALOG_BATCH_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Each scene of a batch is drawn as it is drawn alone.
Verdict BatchDrawsLikeSingleCalls(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_BATCH_H_
