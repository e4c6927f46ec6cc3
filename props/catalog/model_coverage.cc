#include "props/catalog/model_coverage.h"

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict CoverageEqualsTheModel(Subject& subject, const Case& c) {
  const Need need{.space = Space::kWindow, .judges_overdraw = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  return JudgeAgainstTheModel(subject, c);
}

}  // namespace rasterproof::props
