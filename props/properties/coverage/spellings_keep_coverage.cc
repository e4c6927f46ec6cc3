// Another spelling of the same triangles changes no count: vertices that are not shared, or a list
// that starts with another vertex.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {

// Giving every triangle its own vertices, equal to the shared ones bit by bit, changes no count.
extern constinit const Property kDuplicatedVerticesKeepCoverage{
    .name = "DuplicatedVerticesKeepCoverage",
    .group = "coverage",
    .clause = "Vertices are positions: equal bits cover alike, shared by an index or not.",
    .tolerance = kExact,
    .domains = kMeshes,
    .gate = {.space = Space::kEither},
    .ask =
        [](const PlacedCase& c, const Description&) {
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
        },
};

// Rotating a triangle's vertex list changes no count.
extern constinit const Property kVertexRotationKeepsCoverage{
    .name = "VertexRotationKeepsCoverage",
    .group = "coverage",
    .clause = "A triangle is the same whichever vertex the list starts with.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither},
    .ask =
        [](const PlacedCase& c, const Description&) {
          std::vector<Variation> rotations;
          Scene rotated = c.scene;
          for (int turn = 1; turn < 3; ++turn) {
            for (Triangle& t : rotated.triangles) t = {t[1], t[2], t[0]};
            rotations.push_back({rotated, "the unrotated triangles' after " + std::to_string(turn) +
                                              " rotation(s)"});
          }
          return CompareVariations(c, rotations);
        },
};

}  // namespace rasterproof::props
