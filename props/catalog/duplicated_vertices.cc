#include "props/catalog/duplicated_vertices.h"

#include <cstddef>
#include <cstdint>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict DuplicatedVerticesKeepCoverage(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  Case unindexed = c;
  unindexed.scene.vertices.clear();
  for (Triangle& t : unindexed.scene.triangles) {
    for (std::int32_t& index : t) {
      const Vertex& vertex = c.scene.vertices[static_cast<std::size_t>(index)];
      index = static_cast<std::int32_t>(unindexed.scene.vertices.size());
      unindexed.scene.vertices.push_back(vertex);
    }
  }
  return SameAsUnvaried(subject, c, unindexed, "that of the indexed triangles");
}

}  // namespace rasterproof::props
