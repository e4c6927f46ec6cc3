// Twice the area, from any vertex.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_ROTATION_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_ROTATION_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// E(v0, v1; v2), E(v1, v2; v0) and E(v2, v0; v1) are one number, up to the bounds claimed for
/// each.
Verdict CyclicRotationKeepsTheArea(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_ROTATION_H_
