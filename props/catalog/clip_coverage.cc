#include "props/catalog/clip_coverage.h"

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict ClipSpaceCoverageEqualsTheModel(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kClip})) return *refusal;
  return JudgeAgainstTheModel(subject, c);
}

}  // namespace rasterproof::props
