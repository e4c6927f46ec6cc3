// Clip-space triangles, behind the eye or across it as they may be, cover what the ray through the sample meets.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  const Need need{.space = Space::kClip, .judges_overdraw = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  return JudgeAgainstTheModel(subject, c);
}

}  // namespace

constinit const Property kClipSpaceCoverageEqualsTheModel{
    .name = "ClipSpaceCoverageEqualsTheModel",
    .group = "coverage",
    .clause =
        "A clip-space triangle covers what the ray through the sample meets in front of the "
        "eye (Olano and Greer 1997).",
    .precondition =
        "contract sample-exact; coordinates within the limit; clip space; no near clipping",
    .tolerance = kExact,
    .domains = kClipSpace,
    .check = Judge,
};

}  // namespace rasterproof::props
