#include "props/judging/signed_coverage.h"

#include <cstddef>

#include "props/judging/places.h"
#include "props/judging/planar_mesh.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"

namespace rasterproof::props {

std::optional<Verdict> CannotJudgeSignedCoverage(const Subject& subject, const Case& c,
                                                 const Need& need) {
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return refusal;
  if (c.profile.overdraw) {
    return Verdict::NotApplicable("the profile leaves it open how often an edge is drawn");
  }
  return OwnsNoEdges(c.profile);
}

Verdict SignedCoverageIs(Subject& subject, const Case& c, const std::vector<std::int64_t>& expected,
                         const std::string& what, const Spared& spared) {
  const CoverageCounts counts = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  std::uint64_t not_judged = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bool is_right = counts.Signed(k) == expected[k];
    if (is_right && counts.Count(k) == 0 && expected[k] == 0) continue;
    if (is_right && spared.outline.IsEmpty() && spared.open.IsEmpty()) {
      ++exercised;
      continue;
    }
    Witness witness = WitnessOfCounts(counts, counts, k);
    const Point2 at = PlaceOf(c, witness.x, witness.y, witness.sample).at;
    if (spared.outline.IsNear(at)) continue;
    if (spared.open.CanCover(at)) {
      ++not_judged;
      continue;
    }
    ++exercised;
    if (is_right) continue;
    witness.expected = "front - back = " + std::to_string(expected[k]) + ", " + what;
    return Verdict::Violated(exercised, "signed coverage is not " + what, witness);
  }
  Verdict verdict = Verdict::Held(exercised);
  verdict.not_judged = not_judged;
  return verdict;
}

}  // namespace rasterproof::props
