// Bad triangles among good ones.
#ifndef RASTERPROOF_PROPS_CATALOG_POISON_H_
#define RASTERPROOF_PROPS_CATALOG_POISON_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Drawing triangles that are not finite or have no area among the others changes no count.
Verdict BadTrianglesPoisonNoOthers(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_POISON_H_
