// Hard scenes for engines that are not ours: drawn by the domains of `rasterproof list domains`,
// and made simpler by the passes of its shrinker. kit/rapidcheck.h makes RapidCheck's generators
// of them; any other engine that has a random number and a list of simpler values can take them
// as they are. Link rasterproof::rasterproof_fuzz.
#ifndef RASTERPROOF_KIT_HARD_SCENES_H_
#define RASTERPROOF_KIT_HARD_SCENES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::kit {

/// Returns the names of the domains that draw scenes of window space for this profile.
///
/// Domain:     the name of a preset: "real", "gl-canonical", "vulkan".
/// Error:      InputError if there is none of the name.
std::vector<std::string_view> HardDomains(std::string_view profile = "real");

/// Returns a scene of float32 coordinates, the same for the same arguments in every version.
///
/// Domain:     one of HardDomains(profile).
/// Error:      InputError if it is none.
Scene DrawHardScene(std::string_view domain, std::string_view profile, std::uint64_t number);

/// Returns simpler scenes to try in its place, the boldest first: fewer triangles, a smaller
/// target, whole pixels, shorter numbers. Each is strictly simpler in a well-founded order.
std::vector<Scene> SimplerScenes(const Scene& scene);

/// Returns the scene as a file's text, which `rasterproof explain -` takes.
std::string SceneText(const Scene& scene);

/// A sample and a directed edge a -> b that passes it closely, or exactly.
struct EdgeSample {
  Point2 a;
  Point2 b;
  Point2 sample;

  friend bool operator==(const EdgeSample&, const EdgeSample&) = default;
};

/// Returns an edge of a scene of the domain `near-edge`, and a sample next to it.
EdgeSample DrawEdgeSample(std::string_view profile, std::uint64_t number);

/// Returns simpler ones: moved by whole pixels, ends nearer to the sample, one number changed.
std::vector<EdgeSample> SimplerEdgeSamples(const EdgeSample& from);

/// Returns the sign of E(a, b; sample) = (sample.x - a.x)(b.y - a.y) - (sample.y - a.y)(b.x - a.x).
///
/// Domain:     finite.
/// Error:      none: it is exact.
int ExactSign(const EdgeSample& at);

}  // namespace rasterproof::kit

#endif  // RASTERPROOF_KIT_HARD_SCENES_H_
