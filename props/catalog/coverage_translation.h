// Coverage of a scene moved by whole pixels.
#ifndef RASTERPROOF_PROPS_CATALOG_COVERAGE_TRANSLATION_H_
#define RASTERPROOF_PROPS_CATALOG_COVERAGE_TRANSLATION_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Moving the scene by whole pixels moves the counts, where the sums are exact, of the input
/// format and within the limit.
Verdict IntegerTranslationMovesCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_COVERAGE_TRANSLATION_H_
