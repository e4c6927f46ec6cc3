// The sum of the weights.
#ifndef RASTERPROOF_PROPS_CATALOG_WEIGHT_SUM_H_
#define RASTERPROOF_PROPS_CATALOG_WEIGHT_SUM_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The three weights, added exactly, sum to one within the bound claimed for the form.
Verdict WeightsSumToOne(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WEIGHT_SUM_H_
