// Edge values at the ends of the edge.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_ENDS_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_ENDS_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// E(a, b; a) and E(a, b; b) are zero up to the bound claimed there: exactly, where the subject
/// claims to be exact.
Verdict EdgeIsZeroAtItsEnds(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_ENDS_H_
