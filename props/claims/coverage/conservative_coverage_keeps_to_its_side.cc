// A triangle drawn alone covers at least the samples that the canonical model covers (contract conservative-over), or at most those (conservative-under); a mesh counts at least or at most as often.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/profile.h"
#include "exact/coverage.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostSingles = 64;

// Which way a subject may stray decides what fails; a facing that strays is not looked at.
Verdict Judge(Subject& subject, const Case& c, bool over) {
  const CoverageCounts expected = exact::Coverage(c.scene, c.profile, WholeTarget(c));
  const CoverageCounts observed = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t truth = expected.Count(k);
    const std::uint32_t seen = observed.Count(k);
    if (truth != 0 || seen != 0) ++exercised;
    if (over ? seen >= truth : seen <= truth) continue;
    return Verdict::Violated(exercised,
                             over ? "conservative over: a covered sample is left out"
                                  : "conservative under: a sample is covered that is not covered",
                             WitnessOfCounts(observed, expected, k));
  }
  return Verdict::Held(exercised);
}

Verdict Judge(Subject& subject, const Case& c) {
  const bool over = c.profile.contract == Contract::kConservativeOver;
  if (!over && c.profile.contract != Contract::kConservativeUnder) {
    return Verdict::NotApplicable("the profile's contract is not conservative");
  }
  const Need need{.space = Space::kEither, .any_contract_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  std::uint64_t exercised = 0;
  // One triangle's excess must not make up for another's lack.
  for (std::size_t t = 0; t < std::min(kMostSingles, c.scene.triangles.size()); ++t) {
    Verdict alone = Judge(subject, OnlyTriangles(c, {t}), over);
    exercised += alone.exercised;
    alone.exercised = exercised;
    if (alone.witness) alone.witness->triangle = static_cast<int>(t);
    if (alone.outcome == Outcome::kViolated) return alone;
  }
  Verdict whole = Judge(subject, c, over);
  whole.exercised += exercised;
  return whole;
}

}  // namespace

constinit const Property kConservativeCoverageKeepsToItsSide{
    .name = "ConservativeCoverageKeepsToItsSide",
    .group = "coverage",
    .clause =
        "Conservative coverage strays to one side only: an overestimate leaves no covered "
        "sample out, an underestimate adds none.",
    .precondition = "contract conservative over or under; coordinates within the limit",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
};

}  // namespace rasterproof::props
