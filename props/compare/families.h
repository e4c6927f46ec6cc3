// The rows of the catalogue of stiff and extreme cases: every domain and every small world.
#ifndef RASTERPROOF_PROPS_COMPARE_FAMILIES_H_
#define RASTERPROOF_PROPS_COMPARE_FAMILIES_H_

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "core/comparison.h"
#include "core/scene.h"
#include "core/subject.h"
#include "props/compare/compare.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"

namespace rasterproof::props {

/// Families that are hard for the same reason, and what a right rasterizer does on all of them.
struct Theme {
  std::string_view name;
  std::string_view right;  ///< a sentence
};

/// A domain; or a small world, every case of which is drawn; or a scene, which is its only case.
struct Family {
  std::string_view name;
  std::string_view summary;  ///< what is hard about it, one line
  const Theme* theme = nullptr;
  const Domain* domain = nullptr;
  const World* world = nullptr;
  const Scene* scene = nullptr;  ///< exactly one of the three is set
};

/// Every domain and every world, by theme.
std::vector<Family> Families();

struct FamilyPlan {
  std::uint64_t seed = 1;
  /// Of each domain. A world has its own number; one of more than 100 times this is excused.
  std::uint64_t cases = 100;
  /// Worlds of larger targets are left out.
  std::int64_t most_pixels = std::numeric_limits<std::int64_t>::max();
  Limits limits = {};
};

/// Draws the first cases of the family, named FAMILY:INDEX@SEED, without culling or scissor, to be
/// judged by facing where that can be (DrawToJudge). A cell in which no case fails is excused if
/// more than twenty of its cases are for each that is not.
///
/// Domain:     a subject whose profile is about samples, not squares.
std::vector<Cell> CompareFamily(Subject& subject, const Family& family,
                                std::span<const Yardstick> yardsticks, const FamilyPlan& plan);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_FAMILIES_H_
