// A mesh that does not fold or overlap covers every sample inside exactly once, and none outside.
//
// That needs no coverage oracle: inside is where the boundary's winding number is not zero.
#include "props/judging/mesh/planar_mesh.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace embedded_mesh_samples_are_covered_once {

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CompareWithItsWinding(c, subject);
}

}  // namespace embedded_mesh_samples_are_covered_once

extern constinit const Property kEmbeddedMeshSamplesAreCoveredOnce{
    .name = "EmbeddedMeshSamplesAreCoveredOnce",
    .group = "coverage",
    .clause =
        "Polygons on either side of a common edge produce exactly one fragment for a sample "
        "on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization); at "
        "a shared vertex D3D11.3 functional specification 3.4.2.1 (top-left rule).",
    .required_by = kOneOwnerClauses,
    .tolerance = kExact,
    .domains = kMeshesAnySpace,
    .gate =
        {.space = Space::kEither,
         .contract = ContractNeeded::kWatertight,
         .judges_clipped = true,
         .rules = kPlanarMeshRules,
         .asks_oracle = true,
         .where =
             "shared ties: at least once, away from edges once; the snapped mesh has one facing, "
             "in clip space as seen from the eye, and does not overlap itself; where vertices may "
             "move away from the outline and from triangles that a legal choice turns"},
    .ask = embedded_mesh_samples_are_covered_once::Ask,
    .blame = [](const PlacedCase& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, WholeTarget(c)); },
};

}  // namespace rasterproof::props
