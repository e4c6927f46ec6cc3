#include "props/catalog/repeated_draw.h"

#include <cstdint>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict EqualDrawsGiveEqualCounts(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .any_contract_suffices = true, .judges_clipped = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  CoverageCounts twice = Drawn(subject, c.scene, c.profile, c.options);
  CoverageCounts doubled = twice;
  for (std::uint32_t& count : doubled.front) count *= 2;
  for (std::uint32_t& count : doubled.back) count *= 2;
  subject.Draw(c.scene, c.options, twice);
  return SameCounts(twice, doubled, DecisionsOf(c), "twice that of one draw");
}

}  // namespace rasterproof::props
