#include "props/infer/observer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "props/domains/input_lattice.h"

namespace rasterproof::props {

CoverageCounts Observer::Raw(const Scene& scene) {
  CoverageCounts counts(scene.width, scene.height, info().profile.lattice.samples());
  ++draws_;
  last_scene_ = scene;
  if (info().takes_window) {
    subject_.Draw(scene, {}, counts);
  } else {
    Scene clip = scene;  // w is 1 already
    clip.clip_space = true;
    subject_.Draw(clip, {}, counts);
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
