// The error of barycentric weights.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_ERROR_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_ERROR_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Every weight lies within the subject's own proven bound of lambda_i, in every form; the
/// unsigned form only inside the closed triangle, where alone it means lambda_i.
Verdict WeightsStayWithinTheirBound(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_ERROR_H_
