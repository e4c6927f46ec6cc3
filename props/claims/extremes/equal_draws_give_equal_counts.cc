// Drawing the same scene again adds the same counts again.
#include <cstdint>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .any_contract_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  CoverageCounts twice = Drawn(subject, c.scene, c.profile, c.options);
  CoverageCounts doubled = twice;
  for (std::uint32_t& count : doubled.front) count *= 2;
  for (std::uint32_t& count : doubled.back) count *= 2;
  subject.Draw(c.scene, c.options, twice);
  return SameCounts(twice, doubled, DecisionsOf(c), "twice that of one draw");
}

}  // namespace

constinit const Property kEqualDrawsGiveEqualCounts{
    .name = "EqualDrawsGiveEqualCounts",
    .group = "extremes",
    .clause = "Equal calls give equal counts, and counts are added to.",
    .precondition = "any contract but none; coordinates within the limit",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
    .is_about_sequence = true,
};

}  // namespace rasterproof::props
