#include "props/run/facings.h"

#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"
#include "props/run/facing_draws.h"

namespace rasterproof::props {

void DrawByFacing(Subject& subject, const Scene& scene, const DrawOptions& options,
                  CoverageCounts& counts) {
  const SubjectInfo& info = subject.Info();
  if (info.coverage == CoverageKind::kFacingCounts) {
    return DrawOnto(subject, scene, options, counts);
  }
  const std::vector<FacingDraw> parts =
      FacingDraws({scene, options, counts.samples}, info.coverage, info.profile);
  const CallEnd end = DrawFacings(subject, parts, counts);
  if (end.stop != Stop::kNone) throw SubjectStop(end);
}

}  // namespace rasterproof::props
