// A profile on targets of one size.
#ifndef RASTERPROOF_MODEL_TARGET_PROFILE_H_
#define RASTERPROOF_MODEL_TARGET_PROFILE_H_

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof {

/// A profile with the snap, the sample locations and the tie rule that it has on targets of one
/// size; `by_target_size` is empty. For another size, start from the stated profile again.
struct TargetProfile : Profile {
  TargetProfile(const Profile& stated, int width, int height);
  /// Makes the profile for the scene's target.
  TargetProfile(const Profile& stated, const Scene& scene);
};

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_TARGET_PROFILE_H_
