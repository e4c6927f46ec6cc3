// A fragment's depth and its weights.
#ifndef RASTERPROOF_PROPS_CATALOG_FRAGMENT_DEPTH_H_
#define RASTERPROOF_PROPS_CATALOG_FRAGMENT_DEPTH_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The depth at a covered sample is what the subject's own weights give from the vertices' depths.
Verdict FragmentDepthFollowsItsWeights(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_FRAGMENT_DEPTH_H_
