#include "props/judging/as_shown.h"

#include <algorithm>
#include <string>
#include <utility>

namespace rasterproof::props {

bool IsJudgedAsShown(CoverageKind coverage, std::size_t triangles, std::uint64_t samples) {
  const bool counts = coverage == CoverageKind::kFacingCounts || coverage == CoverageKind::kCounts;
  return !counts && (triangles > kMostCallsByTriangle ||
                     triangles > kMostSamplesByTriangle / std::max<std::uint64_t>(samples, 1));
}

bool IsJudgedAsShown(const SubjectInfo& info, const Scene& scene) {
  return IsJudgedAsShown(
      info.coverage, scene.triangles.size(),
      CoverageCounts::Size(scene.width, scene.height, info.profile.pattern.samples()));
}

CoverageCounts AsShown(CoverageCounts counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] = std::min(counts.Count(k), 1U);
    counts.back[k] = 0;
  }
  return counts;
}

Verdict NeverHolds(Verdict verdict) {
  if (verdict.outcome == Outcome::kViolated) return verdict;
  return Verdict::NotExercised(std::string(kJudgedAsShown));
}

}  // namespace rasterproof::props
