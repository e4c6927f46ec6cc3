// A larger target keeps the counts of the samples it shares with the smaller one.
#include <array>
#include <cstdint>
#include <string>

#include "core/scene.h"
#include "model/target_model.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

CoverageCounts LeftPart(const CoverageCounts& wide, int width) {
  CoverageCounts part(width, wide.height, wide.samples);
  for (int row = 0; row < wide.height; ++row) {
    for (int x = 0; x < width; ++x) {
      for (int s = 0; s < wide.samples; ++s) {
        part.front[part.Index(x, row, s)] = wide.front[wide.Index(x, row, s)];
        part.back[part.Index(x, row, s)] = wide.back[wide.Index(x, row, s)];
      }
    }
  }
  return part;
}

Verdict Judge(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  const std::array<int, 2> widths{c.scene.width + 1, 2 * c.scene.width + 7};
  const CoverageCounts expected = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  for (const int width : widths) {
    Scene wider = c.scene;
    wider.width = width;
    const auto samples = CoverageCounts::Size(width, c.scene.height, c.profile.lattice.samples());
    if (width > kMaxTargetSide || samples > kMaxTargetSamples) continue;
    // A profile can state another model for wider targets.
    const Profile wide = ForTarget(c.profile, width, c.scene.height);
    if (wide != ForTarget(c.profile, c.scene.width, c.scene.height)) continue;
    const CoverageCounts observed =
        LeftPart(Drawn(subject, wider, c.profile, WholeTarget(c)), c.scene.width);
    const Verdict verdict =
        SameCounts(observed, expected, DecisionsOf(c),
                   "the narrower target's when " + std::to_string(width) + " pixels wide");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kTargetWidthKeepsCoverage{
    .name = "TargetWidthKeepsCoverage",
    .group = "incremental",
    .clause = "Coverage depends on the sample and the triangle, not on the size of the target.",
    .precondition = kSampleExactOnly,
    .tolerance = kExact,
    .domains = kCoverage,
    .check = Judge,
};

}  // namespace rasterproof::props
