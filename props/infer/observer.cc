#include "props/infer/observer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rasterproof::props {

DrawJob Observer::JobOf(const Scene& scene) const {
  DrawJob job{scene, {}, info().profile.lattice.samples()};
  if (!info().takes_window) job.scene.clip_space = true;  // w is 1 already
  return job;
}

CoverageCounts Observer::Raw(const Scene& scene) {
  ++draws_;
  last_scene_ = scene;
  return subject_.Show(JobOf(scene)).counts;
}

std::vector<CoverageCounts> Observer::Draw(std::span<const Scene> scenes) {
  std::vector<DrawJob> jobs;
  for (const Scene& scene : scenes) jobs.push_back(JobOf(scene));
  std::vector<CoverageCounts> counts;
  for (const DrawOutcome& outcome : subject_.DrawMany(jobs)) {
    ++draws_;
    last_scene_ = scenes[counts.size()];
    counts.push_back(Normal(outcome.Get().counts));
  }
  return counts;
}

CoverageCounts Observer::Normal(CoverageCounts counts) const {
  if (facing_ == FacingReport::kReversed) std::swap(counts.front, counts.back);
  if (facing_ == FacingReport::kNotTold) JoinFacings(counts);
  return counts;
}

CoverageCounts Observer::Expected(CoverageCounts exact) const {
  if (facing_ == FacingReport::kNotTold) JoinFacings(exact);
  return exact;
}

void JoinFacings(CoverageCounts& counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) counts.front[k] += counts.back[k];
  std::ranges::fill(counts.back, 0U);
}

}  // namespace rasterproof::props
