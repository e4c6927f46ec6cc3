#include "props/run/facings.h"

#include <cstddef>
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
  std::vector<DrawJob> jobs;
  for (const Part& part : parts) jobs.push_back(part.job);
  const std::vector<DrawOutcome> drawn = subject.DrawMany(jobs);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    AddPart(parts[k], info.coverage, drawn[k].Get().counts, counts);
  }
}

}  // namespace rasterproof::props
