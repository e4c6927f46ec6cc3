// Reversing a triangle's vertex list exchanges front and back counts and changes no total.
#include <utility>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  Case reversed = c;
  for (Triangle& t : reversed.scene.triangles) t = {t[0], t[2], t[1]};
  CoverageCounts expected = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::swap(expected.front, expected.back);
  const CoverageCounts observed = Drawn(subject, reversed.scene, c.profile, WholeTarget(c));
  return SameCounts(observed, expected, DecisionsOf(c),
                    "the unreversed triangles', facing swapped,");
}

}  // namespace

constinit const Property kReversalSwapsFacing{
    .name = "ReversalSwapsFacing",
    .group = "coverage",
    .clause = "Winding decides facing, never coverage.",
    .precondition = kSampleExactOnly,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
};

}  // namespace rasterproof::props
