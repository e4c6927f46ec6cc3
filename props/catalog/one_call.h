// A mesh in one call, and its triangles one by one.
#ifndef RASTERPROOF_PROPS_CATALOG_ONE_CALL_H_
#define RASTERPROOF_PROPS_CATALOG_ONE_CALL_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A call with a mesh gives what the calls with each of its triangles alone add up to: the sum of
/// counts, the union of masks, the winner by the declared order.
Verdict OneCallDrawsLikeItsTriangles(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_ONE_CALL_H_
