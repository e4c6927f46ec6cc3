// The model that a profile has on a target of some size.
#ifndef RASTERPROOF_MODEL_TARGET_MODEL_H_
#define RASTERPROOF_MODEL_TARGET_MODEL_H_

#include "core/profile.h"

namespace rasterproof {

/// Returns the profile with the snap, the sample locations and the tie rule that it has on a
/// target of this size.
///
/// Properties: ForTarget(ForTarget(p, a...), b...) is ForTarget(p, b...) in all that it states.
///             A profile without `by_target_size` comes back as it is.
Profile ForTarget(const Profile& profile, int width, int height);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_TARGET_MODEL_H_
