// Rasterizers of the legal sets of APIs whose grid changes: with the target's size, as shipping
// drivers have it, or with the call, which no device reports.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// Snaps to nearest-even with the bits that `bits` says of each call.
FixedStages WithBitsBy(std::string_view preset, std::function<int(const Scene&)> bits) {
  FixedStages stages = StagesOfPreset(preset);
  stages.bits = 12;
  stages.model = [bits = std::move(bits)](Profile& model, const Scene& scene) {
    model.snap = {bits(scene)};
  };
  return stages;
}

// Mesa's radeonsi has so many by the extent of the viewport; here it begins on small targets.
int BitsByExtent(const Scene& scene) {
  const int extent = std::max(scene.width, scene.height);
  return extent <= 16 ? 12 : extent <= 24 ? 10 : 8;
}

// Down along one axis and up along the other.
FixedStages RoundingByAxis(std::string_view preset, int bits) {
  FixedStages stages = StagesOfPreset(preset);
  stages.snap = [bits](double x, bool along_y) {
    const double steps = std::ldexp(x, bits);
    return std::ldexp(along_y ? std::ceil(steps) : std::floor(steps), -bits);
  };
  return stages;
}

std::vector<Mutant> GridVariants() {
  return {
      {"gl-bits-by-viewport", "the grid has 12, 10 or 8 subpixel bits, by the size of the target",
       "Mesa radeonsi", WithBitsBy("gl", BitsByExtent)},
      {"vulkan-bits-by-viewport",
       "the grid has 12, 10 or 8 subpixel bits, by the size of the target", "",
       WithBitsBy("vulkan", BitsByExtent)},
      {"vulkan-rounds-by-axis", "the snap rounds down along x and up along y", "",
       RoundingByAxis("vulkan", 6)},
  };
}

std::vector<Mutant> GridMutants() {
  return {
      {"vulkan-grid-by-list", "one triangle has eight subpixel bits, those of a list have four", "",
       WithBitsBy("vulkan", [](const Scene& scene) { return scene.triangles.size() == 1 ? 8 : 4; }),
       "", "OneGridExplainsEveryCall"},
      {"gl-grid-by-list", "one triangle has eight subpixel bits, those of a list have four", "",
       WithBitsBy("gl", [](const Scene& scene) { return scene.triangles.size() == 1 ? 8 : 4; })},
      {"vulkan-grid-by-crowd", "calls of more than 32 triangles have five subpixel bits", "",
       WithBitsBy("vulkan",
                  [](const Scene& scene) { return scene.triangles.size() > 32 ? 5 : 8; })},
      {"vulkan-grid-by-vertices", "more than twelve vertices have seven subpixel bits", "",
       WithBitsBy("vulkan", [](const Scene& scene) { return scene.vertices.size() > 12 ? 7 : 8; })},
      {"vulkan-grid-by-order",
       "a call has six subpixel bits if its first triangle's indices add up to an odd number", "",
       WithBitsBy("vulkan",
                  [](const Scene& scene) {
                    if (scene.triangles.empty()) return 8;
                    const Triangle& first = scene.triangles.front();
                    return (first[0] + first[1] + first[2]) % 2 == 0 ? 8 : 6;
                  })},
  };
}

}  // namespace

extern constinit const MutantTable kGridVariants{MutantKind::kLegal, 9, GridVariants};
extern constinit const MutantTable kGridMutants{MutantKind::kPlanted, 17, GridMutants};

}  // namespace rasterproof::subjects::mutants
