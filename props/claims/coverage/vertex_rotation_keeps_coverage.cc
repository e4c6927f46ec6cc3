// Rotating a triangle's vertex list changes no count.
#include <cstdint>
#include <string>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  std::uint64_t exercised = 0;
  Case rotated = c;
  for (int turn = 1; turn < 3; ++turn) {
    for (Triangle& t : rotated.scene.triangles) t = {t[1], t[2], t[0]};
    const Verdict verdict =
        SameAsUnvaried(subject, c, rotated,
                       "the unrotated triangles' after " + std::to_string(turn) + " rotation(s)");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kVertexRotationKeepsCoverage{
    .name = "VertexRotationKeepsCoverage",
    .group = "coverage",
    .clause = "A triangle is the same from whichever vertex it is told.",
    .precondition = kSampleExactOnly,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
};

}  // namespace rasterproof::props
