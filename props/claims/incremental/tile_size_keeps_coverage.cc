// The tiles that the target is walked in leave no trace in the coverage.
#include <array>
#include <cstdint>
#include <string>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

// One pixel, an odd size that fits no target, the usual ones, and one larger than most targets.
constexpr std::array<int, 4> kTiles{1, 5, 8, 64};

Asked Ask(const Case& c, const Description& /*subject*/) {
  DrawOptions options = WholeTarget(c);
  options.tile = 0;
  Asked asked;
  asked.checks.push_back(BaseDraw(CountsOf(c.scene, c.profile, options)));
  for (const int tile : kTiles) {
    options.tile = tile;
    Check check;
    check.questions.draws.push_back(CountsOf(c.scene, c.profile, options));
    check.bases = {0};
    check.judge = [&c, tile](const Answers& answers) {
      return SameCounts(answers.draws[1]->counts, answers.draws[0]->counts, DecisionsOf(c),
                        "the subject's own with tiles of " + std::to_string(tile) + " pixels");
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

}  // namespace

constinit const Property kTileSizeKeepsCoverage{
    .name = "TileSizeKeepsCoverage",
    .group = "incremental",
    .clause =
        "How a rasterizer walks its target is not observable: D3D11.3 functional "
        "specification 3.4.2.1 (top-left rule) decides by the sample's position alone.",
    .precondition = kSampleExactOnly,
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither, .shows = Shows::kTiles, .any_model = true},
    .ask = Ask,
};

}  // namespace rasterproof::props
