// A triangle whose area is zero after snapping covers nothing.
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace degenerate_triangles_cover_nothing {

constexpr std::array kRules{ProfileRule{
    [](const Profile& p) { return p.degenerate_triangles != DegenerateTriangles::kUnspecified; },
    "triangles of zero area cover nothing",
    "the profile leaves triangles of zero area unspecified"}};

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  if (c.scene.clip_space && !c.profile.snap.IsNone()) {
    return NotExercised("the area after the division and snapping is not decided");
  }
  const std::vector<std::size_t>& flat = c.flat;
  if (flat.empty()) return NotExercised("every triangle has area");
  Questions questions;
  questions.draws.push_back(CountsOf(c.Only(flat).scene, c.profile, WholeTarget(c)));
  return OneCheck(std::move(questions), [exercised = flat.size()](const Answers& answers) {
    const CoverageCounts& observed = answers.draws[0]->counts;
    const CoverageCounts nothing(observed.width, observed.height, observed.samples);
    return SameCounts(observed, nothing, exercised, "none, the area is zero,");
  });
}

}  // namespace degenerate_triangles_cover_nothing

extern constinit const Property kDegenerateTrianglesCoverNothing{
    .name = "DegenerateTrianglesCoverNothing",
    .group = "coverage",
    .clause =
        "A triangle of zero area after snapping produces nothing (D3D11.3 functional "
        "specification, rasterizer; the profile says so).",
    .required_by = kZeroAreaClauses,
    .tolerance = kExact,
    .domains = kDegenerate,
    .gate = {.space = Space::kEither,
             .rules = degenerate_triangles_cover_nothing::kRules,
             .where = "triangles of zero area"},
    .ask = degenerate_triangles_cover_nothing::Ask,
    .blame = [](const PlacedCase& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, WholeTarget(c)); },
};

}  // namespace rasterproof::props
