#include "props/run/facings.h"

#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"
#include "props/run/parts.h"

namespace rasterproof::props {

void DrawByFacing(Subject& subject, const Scene& scene, const DrawOptions& options,
                  CoverageCounts& counts) {
  const SubjectInfo& info = subject.Info();
  if (info.coverage == CoverageKind::kFacingCounts) return subject.Draw(scene, options, counts);
  const std::vector<Part> parts =
      FacingParts({scene, options, counts.samples}, info.coverage, info.profile);
  DrawParts(subject, parts, counts);
}

}  // namespace rasterproof::props
