// Conservative coverage: never less, or never more, than the model's.
#ifndef RASTERPROOF_PROPS_CATALOG_CONSERVATIVE_H_
#define RASTERPROOF_PROPS_CATALOG_CONSERVATIVE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A triangle drawn alone covers at least the samples that the canonical model covers (contract
/// conservative-over), or at most those (conservative-under); a mesh counts at least or at most as
/// often.
Verdict ConservativeCoverageKeepsToItsSide(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CONSERVATIVE_H_
