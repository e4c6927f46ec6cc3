// Shared edges that leave the target.
#ifndef RASTERPROOF_PROPS_CATALOG_CLIPPED_NEIGHBOURS_H_
#define RASTERPROOF_PROPS_CATALOG_CLIPPED_NEIGHBOURS_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Two triangles that share an edge and of which at least one leaves the target, or passes behind
/// the eye, still cover each sample near that edge exactly as often as they do unclipped.
Verdict NeighboursAreClippedAlike(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CLIPPED_NEIGHBOURS_H_
