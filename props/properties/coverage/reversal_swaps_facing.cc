// Reversing a triangle's vertex list exchanges front and back counts and changes no total.
#include <array>
#include <utility>

#include "core/coverage.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace reversal_swaps_facing {

constexpr std::array kRules{kDrawsBothFacings};

Checks Ask(const PlacedCase& c, const Description& subject) {
  Scene reversed = c.scene;
  for (Triangle& t : reversed.triangles) t = {t[0], t[2], t[1]};
  Questions questions;
  for (const Scene* const scene : {&c.scene, &std::as_const(reversed)}) {
    questions.draws.push_back(WholeCallOf(*scene, c.profile, WholeTarget(c)));
  }
  return OneCheck(std::move(questions),
                  [&c, swaps = TellsFacings(subject)](const Answers& answers) {
                    CoverageCounts expected = answers.draws[0]->counts;
                    if (swaps) std::swap(expected.front, expected.back);
                    return OfDraw(1, SameCounts(answers.draws[1]->counts, expected, DecisionsOf(c),
                                                "the unreversed triangles', facing swapped,"));
                  });
}

}  // namespace reversal_swaps_facing

extern constinit const Property kReversalSwapsFacing{
    .name = "ReversalSwapsFacing",
    .group = "coverage",
    .clause = "Winding decides facing, never coverage.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither, .rules = reversal_swaps_facing::kRules},
    .ask = reversal_swaps_facing::Ask,
};

}  // namespace rasterproof::props
