#include "props/catalog/clip_coverage.h"

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict ClipSpaceCoverageEqualsTheModel(Subject& subject, const Case& c) {
  const Need need{.space = Space::kClip, .judges_overdraw = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  return JudgeAgainstTheModel(subject, c);
}

}  // namespace rasterproof::props
