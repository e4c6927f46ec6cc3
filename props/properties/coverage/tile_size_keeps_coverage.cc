// The tiles that the target is walked in leave no trace in the coverage.
#include <string>

#include "core/draw_options.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace tile_size_keeps_coverage {

// One pixel, an odd size that fits no target, usual ones, and one larger than most targets.
Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  return CompareOption(c, &DrawOptions::tile, 0, {1, 5, 8, 64}, [](int tile) {
    return "the subject's own with tiles of " + std::to_string(tile) + " pixels";
  });
}

}  // namespace tile_size_keeps_coverage

extern const Property kTileSizeKeepsCoverage;
constinit const Property kTileSizeKeepsCoverage{
    .name = "TileSizeKeepsCoverage",
    .group = "coverage",
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
