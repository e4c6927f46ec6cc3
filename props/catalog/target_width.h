// Coverage in a larger target.
#ifndef RASTERPROOF_PROPS_CATALOG_TARGET_WIDTH_H_
#define RASTERPROOF_PROPS_CATALOG_TARGET_WIDTH_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A larger target keeps the counts of the samples it shares with the smaller one.
Verdict TargetWidthKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_TARGET_WIDTH_H_
