// Front counts minus back counts.
#ifndef RASTERPROOF_PROPS_JUDGING_SIGNED_COVERAGE_H_
#define RASTERPROOF_PROPS_JUDGING_SIGNED_COVERAGE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/judging/free_choices.h"
#include "props/judging/outline.h"
#include "props/judging/precondition.h"

namespace rasterproof::props {

/// CannotJudgeCoverage for a subject whose fill rule owns edges consistently.
std::optional<Verdict> CannotJudgeSignedCoverage(const Subject& subject, const Case& c,
                                                 const Need& need);

/// The samples that are not judged: beside an outline, and where a triangle can lie whose facing or
/// extent is the subject's choice.
struct Spared {
  Outline outline;
  OpenTriangles open;
};

/// Holds if front minus back is `expected` at every sample that is not `spared`, culling and
/// scissor off. What the open triangles spare is counted as not judged.
///
/// Shape:      expected: as CoverageCounts.
Verdict SignedCoverageIs(Subject& subject, const Case& c, const std::vector<std::int64_t>& expected,
                         const std::string& what, const Spared& spared = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_SIGNED_COVERAGE_H_
