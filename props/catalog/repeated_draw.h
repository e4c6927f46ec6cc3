// Drawing twice.
#ifndef RASTERPROOF_PROPS_CATALOG_REPEATED_DRAW_H_
#define RASTERPROOF_PROPS_CATALOG_REPEATED_DRAW_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Drawing the same scene again adds the same counts again.
Verdict EqualDrawsGiveEqualCounts(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_REPEATED_DRAW_H_
