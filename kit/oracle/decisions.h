// What legal rasterizers of a profile do with each triangle of a scene alone.
#ifndef RASTERPROOF_KIT_ORACLE_DECISIONS_H_
#define RASTERPROOF_KIT_ORACLE_DECISIONS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::kit {

enum class Decision : std::uint8_t { kMustNot, kMust, kMay };

/// Returns why single samples of the scene are not decided under the profile, or nothing.
std::optional<std::string> WhyNoDecisions(const Scene& scene, const Profile& profile);

/// Returns the decision for each triangle and sample.
///
/// Domain:     WhyNoDecisions() returns nothing.
/// Shape:      [triangle][height][width][sample], top row first.
/// Error:      none: what legal models leave open is kMay, and nothing else.
/// Cost:       as legal::DecidedSamples of each triangle.
std::vector<Decision> DecisionsOf(const Scene& scene, const Profile& profile);

}  // namespace rasterproof::kit

#endif  // RASTERPROOF_KIT_ORACLE_DECISIONS_H_
