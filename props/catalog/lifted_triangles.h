// Homogeneous edges against projected ones.
#ifndef RASTERPROOF_PROPS_CATALOG_LIFTED_TRIANGLES_H_
#define RASTERPROOF_PROPS_CATALOG_LIFTED_TRIANGLES_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A window-space triangle lifted to clip space, each vertex (x w, y w, w) by a positive power of
/// two w of its own, covers what the window-space triangle covers.
Verdict LiftedTrianglesCoverLikeProjectedOnes(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_LIFTED_TRIANGLES_H_
