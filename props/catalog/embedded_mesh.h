// Planar subdivisions.
#ifndef RASTERPROOF_PROPS_CATALOG_EMBEDDED_MESH_H_
#define RASTERPROOF_PROPS_CATALOG_EMBEDDED_MESH_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A mesh that does not fold or overlap covers every sample inside exactly once and none outside.
/// It needs no coverage oracle: inside is where the boundary's winding number is not zero.
Verdict EmbeddedMeshSamplesAreCoveredOnce(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_EMBEDDED_MESH_H_
