// Drawing the same scene again adds the same counts again.
#include <cstdint>
#include <utility>

#include "core/coverage.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace equal_draws_give_equal_counts {

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Questions questions;
  questions.company = Company::kInOrderAlone;
  const DrawQuestion once = WholeCallOf(c.scene, c.profile, c.options);
  questions.draws = {once, once};
  questions.draws.back().onto_the_last = true;
  return OneCheck(std::move(questions), [&c](const Answers& answers) {
    CoverageCounts doubled = answers.draws[0]->counts;
    for (std::uint32_t& count : doubled.front) count *= 2;
    for (std::uint32_t& count : doubled.back) count *= 2;
    return SameCounts(answers.draws[1]->counts, doubled, DecisionsOf(c), "twice that of one draw");
  });
}

}  // namespace equal_draws_give_equal_counts

extern constinit const Property kEqualDrawsGiveEqualCounts{
    .name = "EqualDrawsGiveEqualCounts",
    .group = "extremes",
    .clause = "Equal calls give equal counts, and counts are added to.",
    .required_by = kRepeatableClauses,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .is_about_sequence = true,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kAny,
             .judges_clipped = true,
             .judges_degenerates = true},
    .ask = equal_draws_give_equal_counts::Ask,
};

}  // namespace rasterproof::props
