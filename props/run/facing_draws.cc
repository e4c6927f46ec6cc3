#include "props/run/facing_draws.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "props/judging/as_shown.h"
#include "props/judging/by_facing.h"

namespace rasterproof::props {
namespace {

DrawJob Only(const DrawJob& job, std::optional<std::vector<Triangle>> triangles) {
  DrawJob part = job;
  part.triangles = std::move(triangles);
  part.wants = kCoverageAndPrimitiveIds;  // that an id is of the scene is looked at, whoever asks
  return part;
}

}  // namespace

std::vector<FacingDraw> FacingDraws(const DrawJob& job, CoverageKind coverage,
                                    const Profile& profile) {
  if (coverage == CoverageKind::kFacingCounts) return {{job, false}};
  const Scene& scene = *job.scene;
  const std::span<const Triangle> triangles = job.Triangles();
  if (IsJudgedAsShown(coverage, triangles.size(),
                      CoverageCounts::Size(scene.width, scene.height, job.samples))) {
    return {{Only(job, job.triangles), false}};
  }
  Scene drawn = scene;
  drawn.triangles.assign(triangles.begin(), triangles.end());
  TrianglesByFacing sides(exact::PlacedScene(std::move(drawn), profile));
  std::vector<FacingDraw> parts;
  for (const bool is_back : {false, true}) {
    std::vector<Triangle>& side = is_back ? sides.back : sides.front;
    if (coverage == CoverageKind::kCounts) {
      if (!side.empty()) parts.push_back({Only(job, std::move(side)), is_back});
      continue;
    }
    for (const Triangle& t : side) parts.push_back({Only(job, {{t}}), is_back});
  }
  return parts;
}

std::size_t SizeInACall(const DrawJob& job) {
  const Scene& scene = *job.scene;
  return CoverageCounts::Size(scene.width, scene.height, job.samples) + scene.vertices.size() +
         job.Triangles().size();
}

CallEnd DrawFacings(Subject& subject, std::span<const FacingDraw> parts, CoverageCounts& counts) {
  const CoverageKind coverage = subject.Info().coverage;
  while (!parts.empty()) {
    std::vector<DrawJob> jobs;
    std::size_t size = 0;
    for (const FacingDraw& part : parts) {
      size += SizeInACall(part.job);
      if (!jobs.empty() && size > kMostInACall) break;
      jobs.push_back(part.job);
    }
    const std::vector<DrawOutcome> drawn = subject.DrawMany(jobs);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      if (drawn[k].end.stop != Stop::kNone) return drawn[k].end;
      AddFacingDraw(parts[k], coverage, drawn[k].drawing.counts, counts);
    }
    parts = parts.subspan(jobs.size());
  }
  return {};
}

void AddFacingDraw(const FacingDraw& part, CoverageKind coverage, const CoverageCounts& drawn,
                   CoverageCounts& counts) {
  if (coverage == CoverageKind::kFacingCounts) {
    counts += drawn;
    return;
  }
  RequireAsMany(counts, drawn);
  std::vector<std::uint32_t>& side = part.is_back ? counts.back : counts.front;
  for (std::size_t k = 0; k < side.size(); ++k) side[k] += drawn.Count(k);
}

}  // namespace rasterproof::props
