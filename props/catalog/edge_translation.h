// Edge values of a scene moved by whole pixels.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_TRANSLATION_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_TRANSLATION_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Moving edge and sample by whole pixels keeps E, where the sums are exact and on the input
/// lattice.
Verdict IntegerTranslationKeepsEdgeValues(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_TRANSLATION_H_
