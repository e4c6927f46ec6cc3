#include "props/catalog/model_coverage.h"

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict CoverageEqualsTheModel(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kWindow})) return *refusal;
  return JudgeAgainstTheModel(subject, c);
}

}  // namespace rasterproof::props
