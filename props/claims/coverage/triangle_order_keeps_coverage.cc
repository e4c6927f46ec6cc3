// The order of the triangles changes no count.
#include <algorithm>
#include <cstddef>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& /*subject*/) {
  if (c.scene.triangles.size() < 2) return NothingAsked("one triangle has one order");
  Asked asked;
  Case reordered = c;
  std::ranges::reverse(reordered.scene.triangles);
  asked.checks.push_back(VariationCheck(c, reordered, "that in the order given"));
  // A rotation by half, too: a subject that looks at its neighbour in the list sees another one.
  const auto half = static_cast<std::ptrdiff_t>(reordered.scene.triangles.size() / 2);
  std::ranges::rotate(reordered.scene.triangles, reordered.scene.triangles.begin() + half);
  asked.checks.push_back(VariationCheck(c, reordered, "that in the order given"));
  return asked;
}

}  // namespace

constinit const Property kTriangleOrderKeepsCoverage{
    .name = "TriangleOrderKeepsCoverage",
    .group = "coverage",
    .clause = "Coverage of a triangle depends on no other triangle.",
    .tolerance = kExact,
    .domains = kMeshes,
    .gate = {.space = Space::kEither, .any_model = true, .where = kTwoTriangles},
    .ask = Ask,
};

}  // namespace rasterproof::props
