// Profiles of specifications that treat pixels as squares.
#ifndef RASTERPROOF_CORE_SQUARE_PRESETS_H_
#define RASTERPROOF_CORE_SQUARE_PRESETS_H_

#include <array>
#include <optional>
#include <string_view>

#include "core/profile.h"

namespace rasterproof {

/// A preset with squares and its source.
struct SquarePresetInfo {
  std::string_view name;
  std::string_view summary;
  std::string_view source;
  /// What no sentence of the source settles, and how it is taken; may be empty.
  std::string_view assumed;
};

inline constexpr std::array<SquarePresetInfo, 9> kSquarePresets{
    {{"d3d12-conservative-1", "every pixel that the triangle as given overlaps, half a pixel more",
      "Direct3D conservative rasterization 3.2, tier 1",
      "an overlap has area: contact along a border is the implementation's to choose"},
     {"d3d12-conservative-2", "every pixel that the triangle as given overlaps, 1/256 pixel more",
      "Direct3D conservative rasterization 3.2, tier 2",
      "an overlap has area; a triangle that names a vertex twice may be culled"},
     {"d3d12-conservative-3", "as tier 2, which it is for outer coverage",
      "Direct3D conservative rasterization 3.2, tier 3",
      "an overlap has area; a triangle that names a vertex twice may be culled"},
     {"d3d12-inner", "every pixel well inside, none that leaves the triangle as given",
      "Direct3D conservative rasterization 3.2, InnerCoverage",
      "a pixel that a side touches from within does not lie inside, as figure consras7 has it"},
     {"vulkan-overestimate", "every pixel that the triangle touches, with any growth",
      "VK_EXT_conservative_rasterization, overestimation",
      "vertices are placed by up to 1/16 pixel elsewhere, a step of a grid of 4 bits"},
     {"vulkan-underestimate", "no pixel that is not wholly inside",
      "VK_EXT_conservative_rasterization, underestimation",
      "vertices are placed by up to 1/16 pixel elsewhere; a pixel inside may be left out"},
     {"gdal-all-touched", "every pixel whose inside the triangle meets", "GDAL, ALL_TOUCHED",
      "edges within 0.01 pixel of a grid line may count as on it, on either side"},
     {"pdf-fill", "every half-open pixel that the half-open shape meets",
      "PDF Reference, scan conversion rules",
      "whether a ceiling side that has no inside paints a pixel is left open"},
     {"voxel", "every closed pixel that the closed triangle meets",
      "separating axes of boxes and triangles, as voxelizers test them", ""}}};

/// The preset of one of these names, or nothing.
std::optional<Profile> SquarePreset(std::string_view name);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SQUARE_PRESETS_H_
