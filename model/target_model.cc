#include "model/target_model.h"

#include <algorithm>

#include "core/scene.h"

namespace rasterproof {

Profile ForTarget(const Profile& profile, int width, int height) {
  if (profile.targets.empty()) return profile;
  Profile resolved = profile;
  // What holds where no entry fits becomes the last one: so another size can still be asked about.
  if (!profile.targets.back().Fits(kMaxTargetSide, kMaxTargetSide)) {
    resolved.targets.push_back(
        {kMaxTargetSide, kMaxTargetSide, profile.snap, profile.lattice, profile.fill_rule});
  }
  const TargetModel model = *std::ranges::find_if(
      resolved.targets, [&](const TargetModel& entry) { return entry.Fits(width, height); });
  resolved.snap = model.snap;
  resolved.lattice = model.lattice;
  resolved.fill_rule = model.fill_rule;
  return resolved;
}

}  // namespace rasterproof
