#include "props/judging/mesh/signed_coverage.h"

#include <cstddef>
#include <utility>

#include "core/coverage.h"
#include "props/judging/places.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

Verdict SignedCoverageIs(const PlacedCase& c, const CoverageCounts& counts,
                         const std::vector<std::int64_t>& expected, const std::string& what,
                         const Spared& spared) {
  std::uint64_t exercised = 0;
  std::uint64_t not_judged = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bool is_right = counts.Signed(k) == expected[k];
    if (is_right && counts.Count(k) == 0 && expected[k] == 0) continue;
    if (is_right && spared.outline.IsEmpty() && spared.open.IsEmpty() && spared.clipped.IsEmpty()) {
      ++exercised;
      continue;
    }
    Witness witness = WitnessOfCounts(counts, counts, k);
    const Point2 at = PlaceOf(c, witness.x, witness.y, witness.sample).at;
    if (spared.outline.IsNear(at)) continue;
    if (spared.open.CanCover(at) || spared.clipped.MayDecide(at)) {
      ++not_judged;
      continue;
    }
    ++exercised;
    if (is_right) continue;
    witness.expected = {"front - back = ", expected[k], ", " + what};
    return Verdict::Violated(exercised, "signed coverage is not " + what, witness);
  }
  Verdict verdict = Verdict::Held(exercised);
  verdict.not_judged = not_judged;
  return verdict;
}

}  // namespace

Checks CompareSignedCoverage(const PlacedCase& c, std::vector<std::int64_t> expected,
                             std::string what, Spared spared) {
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, WholeTarget(c)));
  return OneCheck(std::move(questions), [&c, expected = std::move(expected), what = std::move(what),
                                         spared = std::move(spared)](const Answers& answers) {
    return SignedCoverageIs(c, answers.draws[0]->counts, expected, what, spared);
  });
}

}  // namespace rasterproof::props
