// The order of drawing.
#ifndef RASTERPROOF_PROPS_CATALOG_TRIANGLE_ORDER_H_
#define RASTERPROOF_PROPS_CATALOG_TRIANGLE_ORDER_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The order of the triangles changes no count.
Verdict TriangleOrderKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_TRIANGLE_ORDER_H_
