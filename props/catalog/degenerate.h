// Triangles of zero area.
#ifndef RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_
#define RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A triangle whose area is zero after snapping covers nothing.
Verdict DegenerateTrianglesCoverNothing(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_
