#include "model/target_model.h"

#include <algorithm>

#include "core/scene.h"

namespace rasterproof {

Profile ForTarget(const Profile& profile, int width, int height) {
  if (profile.by_target_size.empty()) return profile;
  Profile resolved = profile;
  // What holds where no entry fits becomes the last one: so another size can still be asked about.
  if (!profile.by_target_size.back().Fits(kMaxTargetSide, kMaxTargetSide)) {
    resolved.by_target_size.push_back(
        {kMaxTargetSide, kMaxTargetSide, profile.snap, profile.pattern, profile.tie_rule});
  }
  const TargetModel model = *std::ranges::find_if(
      resolved.by_target_size, [&](const TargetModel& entry) { return entry.Fits(width, height); });
  resolved.snap = model.snap;
  resolved.pattern = model.pattern;
  resolved.tie_rule = model.tie_rule;
  return resolved;
}

}  // namespace rasterproof
