// Closed surfaces that may surround the eye.
#ifndef RASTERPROOF_PROPS_CATALOG_CLOSED_AROUND_EYE_H_
#define RASTERPROOF_PROPS_CATALOG_CLOSED_AROUND_EYE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Front minus back of a closed clip-space surface is the same at every sample: the number of
/// times that it winds around the eye.
Verdict ClosedSurfaceAroundTheEyeIsSeenEquallyOften(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CLOSED_AROUND_EYE_H_
