#include "props/judging/as_shown.h"

#include <algorithm>
#include <utility>

namespace rasterproof::props {

bool IsJudgedAsShown(CoverageKind coverage, std::size_t triangles, std::uint64_t samples) {
  const bool counts = coverage == CoverageKind::kFacingCounts || coverage == CoverageKind::kCounts;
  return !counts && triangles > kMostSamplesByTriangle / std::max<std::uint64_t>(samples, 1);
}

bool IsJudgedAsShown(const SubjectInfo& info, const Scene& scene) {
  return IsJudgedAsShown(
      info.coverage, scene.triangles.size(),
      CoverageCounts::Size(scene.width, scene.height, info.profile.lattice.samples()));
}

bool IsJudgedAsShown(const Description& subject, const Case& c) {
  return IsJudgedAsShown(
      subject.info.coverage, c.scene.triangles.size(),
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.lattice.samples()));
}

CoverageCounts AsShown(CoverageCounts counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] = std::min(counts.Count(k), 1U);
    counts.back[k] = 0;
  }
  return counts;
}

}  // namespace rasterproof::props
