#include "props/infer/observer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/error.h"
#include "model/snap_scene.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {

DrawJob Observer::JobOf(const Scene& scene) const {
  const int samples = info().profile.lattice.samples();
  if (info().takes_window) return {scene, {}, samples};
  const auto& transform = info().profile.transform;
  if (transform && transform->viewport != ViewportForm::kNone) {
    throw InputError("subject " + info().name,
                     "its viewport takes no vertex to most of the places that infer looks at",
                     "infer a variant that takes window space, or whose viewport is none");
  }
  Scene clip = scene;
  clip.clip_space = true;  // w is 1 already
  return {std::move(clip), {}, samples};
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

std::optional<Scene> Observer::Given(const Scene& scene) const {
  // Where the subject may take a vertex, not where a grid of its own may put it.
  Profile ungridded = declared_;
  ungridded.snap = {};
  Scene given = scene;
  if (declared_.fixed) given.precision = PrecisionOf(*declared_.fixed);
  const InputLattice lattice(ungridded, given.precision);
  for (Vertex& v : given.vertices) {
    v.x = lattice.RoundWithinLimit(v.x);
    v.y = lattice.RoundWithinLimit(v.y);
  }
  return IsUnclipped(given, declared_) ? std::optional(given) : std::nullopt;
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
