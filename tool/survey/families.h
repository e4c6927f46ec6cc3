// Scenes aimed at the places where real rasterizers go wrong.
#ifndef RASTERPROOF_TOOL_SURVEY_FAMILIES_H_
#define RASTERPROOF_TOOL_SURVEY_FAMILIES_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::tool {

/// What a family's scenes are for.
enum class FamilyKind : std::uint8_t {
  kSingles,  ///< triangles that have nothing to do with each other
  kCover     ///< a subdivision that covers the whole target: every sample exactly once
};

/// Where a family's vertices lie.
enum class FamilyPlace : std::uint8_t {
  kInRange,
  kNearLimits  ///< reaches out to the profile's coordinate limit
};

struct Family {
  std::string_view name;
  FamilyKind kind;
  FamilyPlace place;
  bool on_lattice;  ///< vertices on the model's subpixel grid (1/16 pixel where it has none)
  /// Draws one scene. The model's limit, snap and precision are kept.
  Scene (*draw)(std::uint64_t index, const Profile& model, Precision precision);
};

std::span<const Family> Families();

/// A triangle on its own in a target of 16 x 16, for telling models apart: with vertices on
/// multiples of 1/2 to 1/16 pixel if the index is odd; else off the lattice, every other one near
/// an edge.
Scene FittingScene(std::uint64_t index, Precision precision);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SURVEY_FAMILIES_H_
