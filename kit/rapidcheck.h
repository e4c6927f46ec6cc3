// Hard triangles for a property of your own, as RapidCheck's generators:
//
//     #include "kit/rapidcheck.h"
//     RC_GTEST_PROP(Mine, CoversNoSampleTwice, ()) {
//       const auto pair = *rasterproof::kit::PairsThatShareAnEdge();
//       ...
//     }
//
// What they draw are scenes of the domains that `rasterproof list domains` names, and they shrink
// to minimal pictures: few triangles, a small target, short numbers. A failing one is printed as a
// scene file's text: `rasterproof explain -` shows its pixels. Link rasterproof::rasterproof_fuzz
// and rapidcheck.
#ifndef RASTERPROOF_KIT_RAPIDCHECK_H_
#define RASTERPROOF_KIT_RAPIDCHECK_H_

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "kit/hard_scenes.h"

namespace rasterproof {

/// How RapidCheck prints a scene.
inline void showValue(const Scene& scene, std::ostream& out) { out << kit::SceneText(scene); }

}  // namespace rasterproof

namespace rasterproof::kit {

/// How RapidCheck prints an edge and a sample.
inline void showValue(const EdgeSample& at, std::ostream& out) {
  out << std::hexfloat << "edge (" << at.a.x << ", " << at.a.y << ") to (" << at.b.x << ", "
      << at.b.y << "), sample (" << at.sample.x << ", " << at.sample.y << "), E "
      << (ExactSign(at) == 0  ? "= 0"
          : ExactSign(at) > 0 ? "> 0"
                              : "< 0");
}

namespace rapidcheck_internal {

/// A generator of what `draw` makes of a random number, shrunk by `simpler`.
template <class Value, class Draw, class Simpler>
rc::Gen<Value> GenOf(Draw draw, Simpler simpler) {
  return rc::Gen<Value>([draw, simpler](const rc::Random& random, int) {
    rc::Random numbers(random);
    return rc::shrinkable::shrinkRecur(draw(numbers.next()), [simpler](const Value& value) {
      return rc::seq::fromContainer(simpler(value));
    });
  });
}

}  // namespace rapidcheck_internal

/// Scenes of these domains, by turns as chance has it.
///
/// Domain:     at least one of HardDomains(profile); a preset's name.
/// Error:      InputError, when the first one is drawn.
inline rc::Gen<Scene> ScenesOf(std::vector<std::string> domains, std::string profile = "real") {
  return rapidcheck_internal::GenOf<Scene>(
      [domains = std::move(domains), profile = std::move(profile)](std::uint64_t number) {
        const std::string& domain = domains[static_cast<std::size_t>(number % domains.size())];
        return DrawHardScene(domain, profile, number);
      },
      SimplerScenes);
}

/// Triangles whose edges pass samples closely, or exactly.
inline rc::Gen<Scene> HardTriangles(std::string profile = "real") {
  return ScenesOf({"near-edge", "edges-through-samples", "hardest-sample", "vertices-on-samples"},
                  std::move(profile));
}
/// Long and thin ones, down to a step of the numbers.
inline rc::Gen<Scene> Slivers(std::string profile = "real") {
  return ScenesOf({"needles", "caps", "diagonal-needles"}, std::move(profile));
}
/// Two triangles on either side of a common edge.
inline rc::Gen<Scene> PairsThatShareAnEdge(std::string profile = "real") {
  return ScenesOf({"shared-edge"}, std::move(profile));
}
/// Meshes that do not fold or overlap: inside, each sample lies in one triangle.
inline rc::Gen<Scene> Meshes(std::string profile = "real") {
  return ScenesOf({"fans", "grids", "triangulations"}, std::move(profile));
}

/// Edges and samples next to them: for a test of the edge function alone, against ExactSign().
inline rc::Gen<EdgeSample> NearEdgeSamples(std::string profile = "real") {
  return rapidcheck_internal::GenOf<EdgeSample>(
      [profile = std::move(profile)](std::uint64_t number) {
        return DrawEdgeSample(profile, number);
      },
      SimplerEdgeSamples);
}

}  // namespace rasterproof::kit

#endif  // RASTERPROOF_KIT_RAPIDCHECK_H_
