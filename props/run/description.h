// A subject as properties see it.
#ifndef RASTERPROOF_PROPS_RUN_DESCRIPTION_H_
#define RASTERPROOF_PROPS_RUN_DESCRIPTION_H_

#include "core/subject.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

/// The subject as it is, and what it states.
///
/// Domain:     a subject that outlives what is returned.
Description DescriptionOf(Subject& subject);

/// The description that properties see. A subject with its own transform appears as one that takes
/// window space and shows no edge values or barycentrics.
Description AsJudged(Description subject);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_DESCRIPTION_H_
