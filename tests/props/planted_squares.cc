// Bugs in covering whole pixels, one for each property about them.
#include <optional>
#include <string_view>
#include <vector>

#include "core/square_presets.h"
#include "exact/square_coverage.h"
#include "tests/props/planted_bugs.h"

namespace rasterproof::props {
namespace {

// States the squares of a preset, of vertices as given, and draws those of another region.
Bug DrawingSquares(std::string_view preset, const SquareRegion& drawn) {
  const SquareRule stated = *SquarePreset(preset)->squares;
  return {.draw =
              [drawn](Subject& sound, const Scene& scene, const DrawOptions& options,
                      CoverageCounts& counts) {
                Profile profile = sound.Info().profile;
                profile.squares = SquareRule{drawn, drawn, FlatSquares::kDrawn};
                counts += exact::MayCover({scene, profile}, options);
              },
          .states =
              [stated](Profile& profile) {
                profile.contract = Contract::kSquares;
                profile.squares = stated;
              }};
}

SquareRegion Region(SquareRelation relation, double half_width) {
  return {.relation = relation, .half_width = half_width};
}

}  // namespace

std::vector<PlantedBug> SquarePlantedBugs() {
  using enum SquareRelation;
  return {
      {"SquaresThatMustBeAreCovered", "squares are 2^-20 pixel smaller on every side",
       "spans-exact", DrawingSquares("voxel", Region(kIntersects, -kSquareStep))},
      {"SquaresOutsideTheMayRegionStayFree", "squares are 2^-20 pixel larger on every side",
       "spans-exact", DrawingSquares("voxel", Region(kIntersects, kSquareStep))},
      {"MetSquaresIncludeCoveredCentres", "squares within the triangle are drawn, met ones stated",
       "spans-exact", DrawingSquares("voxel", Region(kContains, 0))},
      {"HeldSquaresHaveCoveredCentres", "squares that are met are drawn, held ones stated",
       "spans-exact", DrawingSquares("vulkan-underestimate", Region(kIntersects, 0))},
      {"SubdivisionLeavesNoSquareUntouched", "squares on the seams of parts are lost",
       "spans-exact", DrawingSquares("voxel", Region(kContains, 0))},
  };
}

}  // namespace rasterproof::props
