#include "props/judging/legal_counts.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {

Comparison ComparisonOf(const PlacedCase& c, const SubjectInfo& info, const DrawOptions& options) {
  if (!c.profile.freedom.IsNone()) {
    const bool by_facing = info.coverage == CoverageKind::kFacingCounts;
    return {WholeCallOf(c.scene, c.profile, options),
            {.coverage = by_facing ? CoverageKind::kCounts : info.coverage}};
  }
  const bool as_shown = IsJudgedAsShown(info, c.scene);
  return {CountsOf(c.scene, c.profile, options),
          {.coverage = as_shown ? CoverageKind::kMask : CoverageKind::kFacingCounts}};
}

Verdict AsAllowed(const legal::Allowed& allowed, const CoverageCounts& drawn,
                  std::uint64_t exercised, const std::string& of) {
  const std::vector<std::size_t> wrong = allowed.Wrong(drawn);
  if (wrong.empty()) return Verdict::Held(exercised);
  if (allowed.IsByPlaces())
    return SameCounts(drawn, allowed.Nearest(drawn), exercised, "the model's" + of);
  Witness witness = WitnessAtIndex(drawn, wrong.front());
  witness.observed = std::to_string(drawn.Count(wrong.front()));
  witness.expected = allowed.WordsAt(wrong.front()) + " in every legal model";
  return Verdict::Violated(exercised,
                           "coverage differs from every legal model's" + of + " at " +
                               std::to_string(wrong.size()) + " of " +
                               std::to_string(drawn.size()) + " samples",
                           std::move(witness));
}

}  // namespace rasterproof::props
