// Writes outside the scissor or the target.
#ifndef RASTERPROOF_PROPS_CATALOG_TARGET_GUARD_H_
#define RASTERPROOF_PROPS_CATALOG_TARGET_GUARD_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Whatever the input, samples outside the scissor keep their values, and the counts keep their
/// shape.
Verdict DrawStaysInsideItsTarget(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_TARGET_GUARD_H_
