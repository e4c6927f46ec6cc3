// Stepping where arithmetic is exact.
#ifndef RASTERPROOF_PROPS_CATALOG_WALK_EXACT_H_
#define RASTERPROOF_PROPS_CATALOG_WALK_EXACT_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Where the subject claims both its walk and its direct evaluation to be exact, they give the
/// same number at every step.
Verdict WalkEqualsDirectWhereExact(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WALK_EXACT_H_
