// Joint legality: where a profile leaves choices, one set of choices explains the whole mesh.
#ifndef RASTERPROOF_PROPS_CATALOG_JOINT_LEGALITY_H_
#define RASTERPROOF_PROPS_CATALOG_JOINT_LEGALITY_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// One legal grid point for every vertex and one legal tie rule explain every sample of every
/// triangle, each drawn alone, and the mesh counts what its triangles count.
Verdict OneLegalModelExplainsTheMesh(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_JOINT_LEGALITY_H_
