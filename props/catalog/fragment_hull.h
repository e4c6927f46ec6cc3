// A fragment's depth and the depths of its vertices.
#ifndef RASTERPROOF_PROPS_CATALOG_FRAGMENT_HULL_H_
#define RASTERPROOF_PROPS_CATALOG_FRAGMENT_HULL_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The depth at a sample in the closed triangle lies between the least and the greatest depth of
/// its vertices.
Verdict FragmentDepthStaysInTheHull(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_FRAGMENT_HULL_H_
