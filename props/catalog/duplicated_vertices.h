// Unindexed triangles.
#ifndef RASTERPROOF_PROPS_CATALOG_DUPLICATED_VERTICES_H_
#define RASTERPROOF_PROPS_CATALOG_DUPLICATED_VERTICES_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Giving every triangle vertices of its own, equal to the shared ones bit by bit, changes no
/// count.
Verdict DuplicatedVerticesKeepCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_DUPLICATED_VERTICES_H_
