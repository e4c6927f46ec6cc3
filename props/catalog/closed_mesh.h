// Closed surfaces in front of the eye.
#ifndef RASTERPROOF_PROPS_CATALOG_CLOSED_MESH_H_
#define RASTERPROOF_PROPS_CATALOG_CLOSED_MESH_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A closed surface shows as much front as back at every sample.
Verdict ClosedMeshCancels(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_CLOSED_MESH_H_
