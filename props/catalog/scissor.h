// Drawing into part of the target.
#ifndef RASTERPROOF_PROPS_CATALOG_SCISSOR_H_
#define RASTERPROOF_PROPS_CATALOG_SCISSOR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A scissor keeps the counts inside it and leaves none outside.
Verdict ScissorOnlyCutsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_SCISSOR_H_
