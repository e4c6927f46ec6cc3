#include "props/judging/legal_counts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// As SameCounts(), without a second picture of 2^28 samples, which takes 2^31 bytes.
Verdict OnLargeTarget(const legal::Allowed& allowed, const CoverageCounts& drawn,
                      std::uint64_t exercised, const std::string& of) {
  std::uint64_t wrong = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (!allowed.Allows(drawn, k) && wrong++ == 0) first = k;
  }
  Witness witness = WitnessAtIndex(drawn, first);
  const auto [front, back] = allowed.NearestAt(drawn, first);
  witness.observed = {FacingCounts{drawn.front[first], drawn.back[first]}};
  witness.expected = {FacingCounts{front, back}};
  return Verdict::Violated(std::max<std::uint64_t>(exercised, 1),
                           "coverage differs from the model's" + of + " at " +
                               std::to_string(wrong) + " of " + std::to_string(drawn.size()) +
                               " samples",
                           std::move(witness));
}

}  // namespace

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
  if (allowed.AllowsAll(drawn)) return Verdict::Held(exercised);
  if (allowed.IsByPlaces()) {
    if (drawn.size() > kMostCompared) return OnLargeTarget(allowed, drawn, exercised, of);
    return SameCounts(drawn, allowed.Nearest(drawn), exercised, "the model's" + of);
  }
  const std::vector<std::size_t> wrong = allowed.Wrong(drawn);
  Witness witness = WitnessAtIndex(drawn, wrong.front());
  witness.observed = {drawn.Count(wrong.front())};
  witness.expected = {allowed.CountsAt(wrong.front()), " in every legal model"};
  return Verdict::Violated(exercised,
                           "coverage differs from every legal model's" + of + " at " +
                               std::to_string(wrong.size()) + " of " +
                               std::to_string(drawn.size()) + " samples",
                           std::move(witness));
}

}  // namespace rasterproof::props
