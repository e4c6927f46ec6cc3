// How a target is walked leaves no trace in the coverage: not the threads that share the work, not
// the tiles.
#include <string>

#include "core/draw_options.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {

// The number of threads that share the work leaves no trace in the coverage.
extern constinit const Property kThreadCountKeepsCoverage{
    .name = "ThreadCountKeepsCoverage",
    .group = "coverage",
    .clause = "Sharing the work among threads is not observable.",
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither,
             .shows = Shows::kThreads,
             .any_model = true,
             .judges_clipped = true},
    .ask =
        [](const PlacedCase& c, const Description&) {
          return CompareOption<int>(c, &DrawOptions::threads, 1, {2, 3, 8}, [](int threads) {
            return "one thread's with " + std::to_string(threads) + " threads";
          });
        },
};

// The tiles that the target is walked in leave no trace in the coverage.
extern constinit const Property kTileSizeKeepsCoverage{
    .name = "TileSizeKeepsCoverage",
    .group = "coverage",
    .clause =
        "How a rasterizer walks its target is not observable: D3D11.3 functional "
        "specification 3.4.2.1 (top-left rule) decides by the sample's position alone.",
    .tolerance = kExact,
    .domains = kAcrossTiles,
    .gate = {.space = Space::kEither,
             .shows = Shows::kTiles,
             .any_model = true,
             .judges_clipped = true},
    // One pixel, an odd size that fits no target, usual ones, and one larger than most targets.
    .ask =
        [](const PlacedCase& c, const Description&) {
          return CompareOption<int>(c, &DrawOptions::tile, 0, {1, 5, 8, 64}, [](int tile) {
            return "the subject's own with tiles of " + std::to_string(tile) + " pixels";
          });
        },
};

}  // namespace rasterproof::props
