#include "props/catalog/signed_coverage.h"

#include <cstddef>

#include "props/catalog/planar_mesh.h"
#include "props/catalog/redraw.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

std::optional<Verdict> CannotJudgeSignedCoverage(const Subject& subject, const Case& c,
                                                 const Need& need) {
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return refusal;
  if (!OwnsEdgesConsistently(c.profile)) {
    return Verdict::NotApplicable("an inclusive fill rule covers shared edges twice");
  }
  return std::nullopt;
}

Verdict SignedCoverageIs(Subject& subject, const Case& c, const std::vector<std::int64_t>& expected,
                         const std::string& what) {
  const CoverageCounts counts = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.Count(k) != 0 || expected[k] != 0) ++exercised;
    if (counts.Signed(k) == expected[k]) continue;
    Witness witness = WitnessOfCounts(counts, counts, k);
    witness.expected = "front - back = " + std::to_string(expected[k]) + ", " + what;
    return Verdict::Violated(exercised, "signed coverage is not " + what, witness);
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
