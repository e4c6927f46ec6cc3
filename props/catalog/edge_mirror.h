// Edge values of a mirrored scene.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_MIRROR_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_MIRROR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Mirroring in either axis, or exchanging the axes, negates E.
Verdict MirrorNegatesEdgeValues(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_MIRROR_H_
