// Culling a facing removes its counts and keeps the others.
#include <algorithm>
#include <cstdint>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (!subject.Info().takes_culling) return Verdict::NotApplicable("the subject does not cull");
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  const CoverageCounts whole = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    CoverageCounts expected = whole;
    std::ranges::fill(cull == Cull::kFront ? expected.front : expected.back, 0U);
    DrawOptions options = WholeTarget(c);
    options.cull = cull;
    const CoverageCounts observed = Drawn(subject, c.scene, c.profile, options);
    const Verdict verdict =
        SameCounts(observed, expected, DecisionsOf(c),
                   cull == Cull::kFront ? "the back counts alone" : "the front counts alone");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kCullingRemovesOneFacing{
    .name = "CullingRemovesOneFacing",
    .group = "coverage",
    .clause =
        "Culling discards triangles of one facing (Vulkan 1.3, Basic Polygon Rasterization) "
        "and changes no other.",
    .precondition = kSampleExactOnly,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
};

}  // namespace rasterproof::props
