// The tiles that the target is walked in leave no trace in the coverage.
#include <array>
#include <string>

#include "core/coverage.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/all.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace tile_size_keeps_coverage {

// One pixel, an odd size that fits no target, the usual ones, and one larger than most targets.
constexpr std::array<int, 4> kTiles{1, 5, 8, 64};

Asked Ask(const PlacedCase& c, const Description& /*subject*/) {
  DrawOptions options = WholeTarget(c);
  options.tile = 0;
  Asked asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  for (const int tile : kTiles) {
    options.tile = tile;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(c.scene, c.profile, options),
        [&c, tile](const CoverageCounts& observed, const CoverageCounts& base) {
          return SameCounts(observed, base, DecisionsOf(c),
                            "the subject's own with tiles of " + std::to_string(tile) + " pixels");
        }));
  }
  return asked;
}

}  // namespace tile_size_keeps_coverage

constinit const Property kTileSizeKeepsCoverage{
    .name = "TileSizeKeepsCoverage",
    .group = "incremental",
    .clause =
        "How a rasterizer walks its target is not observable: D3D11.3 functional "
        "specification 3.4.2.1 (top-left rule) decides by the sample's position alone.",
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither,
             .shows = Shows::kTiles,
             .any_model = true,
             .judges_clipped = true},
    .ask = tile_size_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
