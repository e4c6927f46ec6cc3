// Triangles told from another vertex on.
#ifndef RASTERPROOF_PROPS_CATALOG_VERTEX_ROTATION_H_
#define RASTERPROOF_PROPS_CATALOG_VERTEX_ROTATION_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Rotating a triangle's vertex list changes no count.
Verdict VertexRotationKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_VERTEX_ROTATION_H_
