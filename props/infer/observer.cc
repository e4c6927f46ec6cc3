#include "props/infer/observer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/error.h"

namespace rasterproof::props {

CoverageCounts Observer::Raw(const Scene& scene) {
  CoverageCounts counts(scene.width, scene.height, info().profile.lattice.samples());
  ++draws_;
  last_scene_ = scene;
  if (info().takes_window) {
    subject_.Draw(scene, {}, counts);
  } else {
    const auto& transform = info().profile.transform;
    if (transform && transform->viewport != ViewportForm::kNone) {
      throw InputError("subject " + info().name,
                       "its viewport takes no vertex to most of the places that infer looks at",
                       "infer a variant that takes window space, or whose viewport is none");
    }
    Scene clip = scene;  // w is 1 already
    clip.clip_space = true;
    subject_.Draw(clip, {}, counts);
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
