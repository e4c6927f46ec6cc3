// The two directions of one edge.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_ANTISYMMETRY_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_ANTISYMMETRY_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// E(b, a; p) is -E(a, b; p), up to the sum of the bounds claimed for both.
Verdict ReversedEdgeChangesSign(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_ANTISYMMETRY_H_
