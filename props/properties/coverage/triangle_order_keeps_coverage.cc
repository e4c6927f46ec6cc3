// The order of the triangles changes no count.
//
// Where the owners of samples on edges are open they may be others in every call: samples are
// compared that all legal models decide alike.
#include <algorithm>
#include <cstddef>

#include "core/freedom.h"
#include "core/scene.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace triangle_order_keeps_coverage {

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  if (c.scene.triangles.size() < 2) return NotExercised("one triangle has one order");
  const auto open = WhereCallsMayDiffer(c, c.profile.freedom.ties == TieOwnership::kOpen);
  if (!open) return NotExercised(kPlacesNotKnown);
  constexpr const char* kInTheOrderGiven = "that in the order given";
  Scene reversed = c.scene;
  std::ranges::reverse(reversed.triangles);
  // A rotation by half, too: a subject that looks at its neighbour in the list sees another one.
  Scene turned = reversed;
  const auto half = static_cast<std::ptrdiff_t>(turned.triangles.size() / 2);
  std::ranges::rotate(turned.triangles, turned.triangles.begin() + half);
  return CompareVariations(c, {{reversed, kInTheOrderGiven}, {turned, kInTheOrderGiven}}, *open);
}

}  // namespace triangle_order_keeps_coverage

extern constinit const Property kTriangleOrderKeepsCoverage{
    .name = "TriangleOrderKeepsCoverage",
    .group = "coverage",
    .clause = "Coverage of a triangle depends on no other triangle.",
    .required_by = kIndependentClauses,
    .tolerance = kExact,
    .domains = kMeshes,
    .gate = {.space = Space::kEither,
             .any_model = true,
             .judges_clipped = true,
             .where = kTwoTriangles},
    .ask = triangle_order_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
