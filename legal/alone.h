// What legal models of a profile do with each triangle of a scene alone.
#ifndef RASTERPROOF_LEGAL_ALONE_H_
#define RASTERPROOF_LEGAL_ALONE_H_

#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "legal/decided.h"

namespace rasterproof::legal {

/// Returns why the samples of the scene's triangles, each drawn alone, are not decided under the
/// profile: it states nothing of single samples, or nothing of this scene. Nothing if they are.
std::optional<std::string> WhyNotAlone(const Scene& scene, const Profile& profile);

/// Returns what is decided of each triangle alone, for points and for whole pixels.
///
/// Domain:     WhyNotAlone() returns nothing.
/// Error:      none: `may` holds what legal models leave open, and nothing else. Of the contracts
///             that state one side of the model the other side is open.
/// Cost:       of a profile with one model as exact::Coverage() of each triangle; else as
///             DecidedSamples().
std::vector<TriangleDecided> DecideAlone(const Scene& scene, const Profile& profile);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_ALONE_H_
