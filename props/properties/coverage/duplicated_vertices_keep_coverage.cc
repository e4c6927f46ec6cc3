// Giving every triangle vertices of its own, equal to the shared ones bit by bit, changes no count.
#include <cstddef>
#include <cstdint>

#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace duplicated_vertices_keep_coverage {

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Scene unindexed = c.scene;
  unindexed.vertices.clear();
  for (Triangle& t : unindexed.triangles) {
    for (std::int32_t& index : t) {
      const Vertex& vertex = c.scene.vertices[static_cast<std::size_t>(index)];
      index = static_cast<std::int32_t>(unindexed.vertices.size());
      unindexed.vertices.push_back(vertex);
    }
  }
  return CompareVariations(c, {{unindexed, "that of the indexed triangles"}});
}

}  // namespace duplicated_vertices_keep_coverage

extern const Property kDuplicatedVerticesKeepCoverage;
constinit const Property kDuplicatedVerticesKeepCoverage{
    .name = "DuplicatedVerticesKeepCoverage",
    .group = "coverage",
    .clause = "Vertices are positions: equal bits cover alike, shared by an index or not.",
    .tolerance = kExact,
    .domains = kMeshes,
    .gate = {.space = Space::kEither},
    .ask = duplicated_vertices_keep_coverage::Ask,
};

}  // namespace rasterproof::props
