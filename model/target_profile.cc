#include "model/target_profile.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rasterproof {

TargetProfile::TargetProfile(const Profile& stated, int width, int height) : Profile(stated) {
  const std::vector<TargetModel> models = std::exchange(by_target_size, {});
  const auto model = std::ranges::find_if(
      models, [&](const TargetModel& entry) { return entry.Fits(width, height); });
  if (model == models.end()) return;
  snap = model->snap;
  pattern = model->pattern;
  tie_rule = model->tie_rule;
}

TargetProfile::TargetProfile(const Profile& stated, const Scene& scene)
    : TargetProfile(stated, scene.width, scene.height) {}

}  // namespace rasterproof
