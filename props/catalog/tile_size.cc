#include "props/catalog/tile_size.h"

#include <array>
#include <cstdint>
#include <string>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {
namespace {

// One pixel, an odd size that fits no target, the usual ones, and one larger than most targets.
constexpr std::array<int, 4> kTiles{1, 5, 8, 64};

}  // namespace

Verdict TileSizeKeepsCoverage(Subject& subject, const Case& c) {
  if (!subject.Info().takes_tiles) {
    return Verdict::NotApplicable("the subject's tiles, if any, can't be chosen");
  }
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  DrawOptions options = WholeTarget(c);
  options.tile = 0;
  const CoverageCounts expected = Drawn(subject, c.scene, c.profile, options);
  std::uint64_t exercised = 0;
  for (const int tile : kTiles) {
    options.tile = tile;
    const CoverageCounts observed = Drawn(subject, c.scene, c.profile, options);
    const Verdict verdict =
        SameCounts(observed, expected, DecisionsOf(c),
                   "the subject's own with tiles of " + std::to_string(tile) + " pixels");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
