// The error of an edge value.
#ifndef RASTERPROOF_PROPS_CATALOG_EDGE_ERROR_H_
#define RASTERPROOF_PROPS_CATALOG_EDGE_ERROR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Every edge value lies within the subject's own proven bound of E(a, b; p).
Verdict EdgeErrorStaysWithinItsBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EDGE_ERROR_H_
