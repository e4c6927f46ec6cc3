// A target that is drawn tile by tile, each in a separate call, is the target drawn whole.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace tiles_drawn_apart_equal_the_whole {

// What a place rounds otherwise by an ulp shows where the snap has a tie.
constexpr auto kMapDomains =
    Both(kCoverageAnySpace, std::to_array<std::string_view>({"deciding-snap-ties"}));

// Three tiles along the longer side: origins that are no powers of two from the target's.
Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  const auto open = WhereCallsMayDiffer(c, MayChooseByCall(c.profile));
  if (!open) return NotExercised(kPlacesNotKnown);
  DrawOptions options = WholeTarget(c);
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  const int side = (std::max(c.scene.width, c.scene.height) + 2) / 3;
  for (int y0 = 0; y0 < c.scene.height; y0 += side) {
    for (int x0 = 0; x0 < c.scene.width; x0 += side) {
      const PixelRect tile{x0, y0, std::min(x0 + side, c.scene.width),
                           std::min(y0 + side, c.scene.height)};
      options.scissor = tile;
      asked.checks.push_back(CheckAgainstBase(
          WholeCallOf(c.scene, c.profile, options),
          [&c, tile, open](const CoverageCounts& observed, const CoverageCounts& whole) {
            return SameCounts(observed, CutTo(tile, open->Expected(observed, whole)),
                              open->Judged(DecisionsOf(c)),
                              "the whole's in the tile at column " + std::to_string(tile.x0) +
                                  " row " + std::to_string(tile.y0));
          }));
    }
  }
  return asked;
}

}  // namespace tiles_drawn_apart_equal_the_whole

extern constinit const Property kTilesDrawnApartEqualTheWhole{
    .name = "TilesDrawnApartEqualTheWhole",
    .group = "coverage",
    .clause =
        "A part of a target drawn by itself is that part of the whole: a map's tiles fit together, "
        "wherever their origins lie.",
    .required_by = kScissorClauses,
    .tolerance = kExact,
    .domains = tiles_drawn_apart_equal_the_whole::kMapDomains,
    .gate = {.space = Space::kEither,
             .shows = Shows::kScissor,
             .any_model = true,
             .judges_clipped = true},
    .ask = tiles_drawn_apart_equal_the_whole::Ask,
};

}  // namespace rasterproof::props
