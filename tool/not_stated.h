// Scenes whose counts a profile does not state.
#ifndef RASTERPROOF_TOOL_NOT_STATED_H_
#define RASTERPROOF_TOOL_NOT_STATED_H_

#include <string>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::tool {

/// Why the counts of the scene's samples are not stated by the profile; empty if they are.
std::string WhyNotStated(const Scene& scene, const Profile& profile);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_NOT_STATED_H_
