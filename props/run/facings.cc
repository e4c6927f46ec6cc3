#include "props/run/facings.h"

#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"
#include "props/run/facing_draws.h"

namespace rasterproof::props {

CallEnd DrawByFacing(Subject& subject, const Scene& scene, const DrawOptions& options,
                     CoverageCounts& counts) {
  const SubjectInfo& info = subject.Info();
  if (info.coverage == CoverageKind::kFacingCounts) {
    const DrawJob job(scene, options, counts.samples);
    DrawOutcome outcome = std::move(subject.DrawMany({&job, 1}).front());
    if (outcome.end.stop == Stop::kNone) counts += outcome.drawing.counts;
    return std::move(outcome.end);
  }
  const std::vector<FacingDraw> parts =
      FacingDraws({scene, options, counts.samples}, info.coverage, info.profile);
  return DrawFacings(subject, parts, counts);
}

}  // namespace rasterproof::props
