// Rasterizers of the legal sets of APIs that take coordinates up to 2^30 pixels, and bugs that only
// large coordinates show.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/draw_options.h"
#include "core/scene.h"
#include "subjects/mutants/clipping.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr double kFarLimit = 0x1p30;
constexpr std::int64_t kStepsOfAPixel = 256;

FixedStages FarReaching(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.profile.coordinate_limit = kFarLimit;
  return stages;
}

double LargestOf(const std::array<Vertex, 3>& v) {
  double largest = 0;
  for (const Vertex& p : v) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

std::int64_t LargestOf(const GridTriangle& t) {
  std::int64_t largest = 0;
  for (const GridPoint& p : t.v) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

// The box is that of corners cut to 32 bits.
FixedStages BoxOf32Bits(std::string_view preset) {
  FixedStages stages = FarReaching(preset);
  stages.box = [](PixelRect& box, const GridTriangle& t, const Scene&) {
    const auto cut = [](std::int64_t x) { return std::int64_t{static_cast<std::int32_t>(x)}; };
    const auto [left, right] = std::minmax({cut(t.v[0].x), cut(t.v[1].x), cut(t.v[2].x)});
    const auto [top, bottom] = std::minmax({cut(t.v[0].y), cut(t.v[1].y), cut(t.v[2].y)});
    const auto pixel = [](std::int64_t x) { return static_cast<int>(x / kStepsOfAPixel); };
    box = {std::max(box.x0, pixel(left) - 2), std::max(box.y0, pixel(top) - 2),
           std::min(box.x1, pixel(right) + 2), std::min(box.y1, pixel(bottom) + 2)};
  };
  return stages;
}

// Edge values wrap in 64 bits.
FixedStages ValuesOf64Bits(std::string_view preset) {
  FixedStages stages = FarReaching(preset);
  stages.value = [](const GridEdge& e, const Sample& at) {
    const auto bits = [](std::int64_t x) { return static_cast<std::uint64_t>(x); };
    return static_cast<std::int64_t>(bits(at.at.x - e.a.x) * bits(e.b.y - e.a.y) -
                                     bits(at.at.y - e.a.y) * bits(e.b.x - e.a.x));
  };
  return stages;
}

// Triangles that reach `pixels` or further take a path on which they own all their edges.
FixedStages TiesOtherwiseFrom(double pixels) {
  FixedStages stages = FarReaching("vulkan");
  const auto steps = static_cast<std::int64_t>(pixels) * kStepsOfAPixel;
  stages.owns = [steps](const GridEdge& e, const GridTriangle& t, const Sample&) {
    return e.owns || LargestOf(t) >= steps;
  };
  return stages;
}

// Triangles that reach `pixels` or further take a path on which the snap rounds down.
FixedStages RoundsOtherwiseFrom(std::string_view preset, double pixels) {
  FixedStages stages = FarReaching(preset);
  stages.vertices = [pixels](std::array<Vertex, 3>& v) {
    if (!(LargestOf(v) >= pixels)) return;
    for (Vertex& p : v) {
      p.x = std::floor(p.x * kStepsOfAPixel) / kStepsOfAPixel;
      p.y = std::floor(p.y * kStepsOfAPixel) / kStepsOfAPixel;
    }
  };
  return stages;
}

std::vector<Mutant> FarVariants() {
  return {
      {"vulkan-far", "coordinates reach 2^30 pixels", "", FarReaching("vulkan")},
      {"gl-far-rounds-down", "coordinates reach 2^30 pixels, and the snap rounds down", "",
       RoundsOtherwiseFrom("gl", 0)},
      {"vulkan-far-clips", "coordinates reach 2^30 pixels, what leaves the target is clipped", "",
       ClippingStages{.base = FarReaching("vulkan"), .beyond = 0}},
  };
}

std::vector<Mutant> FarMutants() {
  return {
      {"vulkan-far-box-of-32-bits", "the box is that of corners cut to 32 bits", "",
       BoxOf32Bits("vulkan"), "", "SharedEdgeSamplesAreCoveredOnce"},
      {"gl-far-values-of-64-bits", "edge values wrap in 64 bits", "", ValuesOf64Bits("gl"), "",
       "SharedEdgeSamplesAreCoveredOnce"},
      {"vulkan-far-ties-otherwise", "triangles that reach 2^24 pixels own all their edges", "",
       TiesOtherwiseFrom(0x1p24)},
      {"gl-far-rounds-otherwise", "vertices of triangles that reach 2^11 pixels are rounded down",
       "", RoundsOtherwiseFrom("gl", 0x1p11)},
      {"vulkan-far-rounds-otherwise",
       "vertices of triangles that reach 2^27 pixels are rounded down", "",
       RoundsOtherwiseFrom("vulkan", 0x1p27)},
  };
}

}  // namespace

extern constinit const MutantTable kFarVariants{MutantKind::kLegal, 11, FarVariants};
extern constinit const MutantTable kFarMutants{MutantKind::kPlanted, 19, FarMutants};

}  // namespace rasterproof::subjects::mutants
