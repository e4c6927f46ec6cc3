// The sign of an edge value.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_SIGN_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_SIGN_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Where |E| exceeds the bound that the subject claims, its value has the sign of E; where it
/// claims to be exact, always, zero included.
Verdict EdgeSignIsRightOutsideItsBand(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_SIGN_H_
