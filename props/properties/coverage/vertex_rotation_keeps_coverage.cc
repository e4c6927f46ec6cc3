// Rotating a triangle's vertex list changes no count.
#include <string>
#include <vector>

#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace vertex_rotation_keeps_coverage {

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  std::vector<Variation> rotations;
  Scene rotated = c.scene;
  for (int turn = 1; turn < 3; ++turn) {
    for (Triangle& t : rotated.triangles) t = {t[1], t[2], t[0]};
    rotations.push_back(
        {rotated, "the unrotated triangles' after " + std::to_string(turn) + " rotation(s)"});
  }
  return CompareVariations(c, rotations);
}

}  // namespace vertex_rotation_keeps_coverage

extern const Property kVertexRotationKeepsCoverage;
constinit const Property kVertexRotationKeepsCoverage{
    .name = "VertexRotationKeepsCoverage",
    .group = "coverage",
    .clause = "A triangle is the same whichever vertex the list starts with.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither},
    .ask = vertex_rotation_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
