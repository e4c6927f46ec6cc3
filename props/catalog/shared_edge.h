// Two triangles on either side of a common edge.
#ifndef RASTERPROOF_PROPS_CATALOG_SHARED_EDGE_H_
#define RASTERPROOF_PROPS_CATALOG_SHARED_EDGE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Near an edge that two triangles share from either side, each sample of their union is covered
/// by exactly one of them.
Verdict SharedEdgeSamplesAreCoveredOnce(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_SHARED_EDGE_H_
