// Triangles told the other way round.
#ifndef RASTERPROOF_PROPS_CATALOG_VERTEX_REVERSAL_H_
#define RASTERPROOF_PROPS_CATALOG_VERTEX_REVERSAL_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Reversing a triangle's vertex list exchanges front and back counts and changes no total.
Verdict ReversalSwapsFacing(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_VERTEX_REVERSAL_H_
