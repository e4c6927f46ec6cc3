// Culling.
#ifndef RASTERPROOF_PROPS_CATALOG_CULLING_H_
#define RASTERPROOF_PROPS_CATALOG_CULLING_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Culling a facing removes its counts and keeps the others.
Verdict CullingRemovesOneFacing(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CULLING_H_
