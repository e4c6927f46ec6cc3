// Coverage drawn by several threads.
#ifndef RASTERPROOF_PROPS_CATALOG_THREAD_COUNT_H_
#define RASTERPROOF_PROPS_CATALOG_THREAD_COUNT_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The number of threads that share the work leaves no trace in the coverage.
Verdict ThreadCountKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_THREAD_COUNT_H_
