// Whatever draws a scene, asked whether it covers one sample of it.
#ifndef RASTERPROOF_BENCH_SCENE_DRAWER_H_
#define RASTERPROOF_BENCH_SCENE_DRAWER_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bench/contender.h"
#include "bench/parameter.h"
#include "core/bench_result.h"
#include "core/evaluators.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"

namespace rasterproof::bench {

/// Draws scenes of one triangle.
class SceneDrawer {
 public:
  virtual ~SceneDrawer() = default;

  virtual const BenchMethod& method() const = 0;
  /// The model that it is held to.
  virtual const Profile& model() const = 0;
  /// Its edge values, if it shows them.
  virtual const EdgeEvaluator* edges() const { return nullptr; }
  /// Whether it draws scenes of this kind and number format.
  virtual bool Takes(const Scene& scene) const = 0;
  /// Whether each case's sample is covered; nothing where the scene was refused. Fewer answers
  /// than cases if it broke down over the case after the last answer.
  ///
  /// Domain:     scenes that it takes.
  virtual std::vector<std::optional<bool>> Covers(std::span<const HardCase* const> cases) = 0;
};

/// Domain:     a contender that DrawsAlone() and outlives the drawer.
std::unique_ptr<SceneDrawer> DrawerOf(Contender& contender);

/// Any subject, in this process or outside: together where that costs less.
///
/// Domain:     a subject of one sample a pixel that outlives the drawer.
std::unique_ptr<SceneDrawer> DrawerOf(Subject& subject);
/// The same, as a method that a result has already.
std::unique_ptr<SceneDrawer> DrawerOf(Subject& subject, BenchMethod method);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_SCENE_DRAWER_H_
