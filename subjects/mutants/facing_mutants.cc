// Rasterizers of the legal sets of APIs that face triangles by what a sentence leaves open, or by
// something that lies just outside.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/draw_options.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// Steps of the base's grid in one pixel, and in one step of a grid of four bits.
constexpr std::int64_t kPixel = 256;
constexpr std::int64_t kCoarseStep = 16;

// The options of a call, for later stages. It is thread-local because the stages of all subjects
// made of one row are copies: a draw stays on its thread, and other properties draw on others.
struct CallState {
  GridPoint corner;  // of the target
  int width = 0;
  int calls = 0;
  Cull cull = Cull::kNone;
};
thread_local CallState call;

FixedStages Facing(std::string_view preset, std::function<void(GridTriangle&)> facing) {
  FixedStages stages = StagesOfPreset(preset);
  stages.facing = std::move(facing);
  return stages;
}

FixedStages Exchanged(std::string_view preset) {
  return Facing(preset, [](GridTriangle& t) { t.front = !t.front; });
}

std::int64_t DoubledArea(const std::vector<GridPoint>& polygon) {
  std::int64_t area = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    area += GridEdge{polygon[0], polygon[k]}.At(polygon[k + 1]);
  }
  return area;
}

// The base has turned the triangle to a positive area: a negative one is of the other side.
void FaceBy(std::int64_t area, GridTriangle& t) {
  if (area <= 0) t.front = area < 0 && !t.front;
}

GridPoint OnCoarseGrid(GridPoint p) {
  const auto nearest = [](std::int64_t x) {
    const std::int64_t moved = x + kCoarseStep / 2;
    return moved - ((moved % kCoarseStep) + kCoarseStep) % kCoarseStep;
  };
  return {nearest(p.x), nearest(p.y)};
}

// What is left of the polygon where `inside`, affine, is not negative; new vertices are truncated
// to the grid.
std::vector<GridPoint> Cut(const std::vector<GridPoint>& polygon,
                           const std::function<std::int64_t(GridPoint)>& inside) {
  std::vector<GridPoint> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const GridPoint a = polygon[k];
    const GridPoint b = polygon[(k + 1) % polygon.size()];
    const std::int64_t at_a = inside(a);
    const std::int64_t at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) == (at_b < 0)) continue;
    kept.push_back(
        {a.x + (b.x - a.x) * at_a / (at_a - at_b), a.y + (b.y - a.y) * at_a / (at_a - at_b)});
  }
  return kept;
}

// Facing is that of what is left of the triangle inside the target, its new vertices on the grid.
FixedStages OfTheClippedPolygon(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.options = [](DrawOptions&, const Scene& scene) {
    call.corner = {scene.width * kPixel, scene.height * kPixel};
  };
  stages.facing = [](GridTriangle& t) {
    std::vector<GridPoint> polygon(t.v.begin(), t.v.end());
    polygon = Cut(polygon, [](GridPoint p) { return p.x; });
    polygon = Cut(polygon, [](GridPoint p) { return p.y; });
    polygon = Cut(polygon, [](GridPoint p) { return call.corner.x - p.x; });
    polygon = Cut(polygon, [](GridPoint p) { return call.corner.y - p.y; });
    FaceBy(DoubledArea(polygon), t);
  };
  return stages;
}

bool Coin(std::uint64_t n) { return (n * 0x9e3779b97f4a7c15U >> 61 & 1U) != 0; }

// The same for every order of the vertices.
bool CoinOf(const GridTriangle& t) {
  std::uint64_t sum = 0;
  for (const GridPoint p : t.v) sum += static_cast<std::uint64_t>(p.x * 7919 + p.y * 104729);
  return Coin(sum);
}

FixedStages ExchangedInEveryOtherCall(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.options = [](DrawOptions&, const Scene&) { ++call.calls; };
  stages.facing = [](GridTriangle& t) {
    if (call.calls % 2 == 0) t.front = !t.front;
  };
  return stages;
}

FixedStages ExchangedOnTargetsOfOddWidth(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.options = [](DrawOptions&, const Scene& scene) { call.width = scene.width; };
  stages.facing = [](GridTriangle& t) {
    if (call.width % 2 != 0) t.front = !t.front;
  };
  return stages;
}

// Some triangles are culled with the other side than the one they are counted on.
FixedStages CullingTheOtherSide(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.options = [](DrawOptions& options, const Scene&) {
    call.cull = std::exchange(options.cull, Cull::kNone);
  };
  stages.box = [](PixelRect& box, const GridTriangle& t, const Scene&) {
    const bool front = t.front != CoinOf(t);
    if (call.cull == (front ? Cull::kFront : Cull::kBack)) box = {0, 0, 0, 0};
  };
  return stages;
}

// Twice the area of the triangle that is drawn, before its vertices snap, in square pixels.
thread_local double given_area = 0;

void NoteArea(std::array<Vertex, 3>& v) {
  given_area = (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x);
}

FixedStages FacingBeforeTheSnap(FixedStages stages) {
  stages.vertices = NoteArea;
  stages.facing = [](GridTriangle& t) {
    if (given_area != 0) t.front = given_area > 0;
  };
  return stages;
}

// Counts are on the side that the triangle has after the snap.
FixedStages CullingBeforeTheSnap(FixedStages stages) {
  stages.vertices = NoteArea;
  stages.options = [](DrawOptions& options, const Scene&) {
    call.cull = std::exchange(options.cull, Cull::kNone);
  };
  stages.box = [](PixelRect& box, const GridTriangle& t, const Scene&) {
    const bool front = given_area == 0 ? t.front : given_area > 0;
    if (call.cull == (front ? Cull::kFront : Cull::kBack)) box = {0, 0, 0, 0};
  };
  return stages;
}

std::vector<Mutant> FacingVariants() {
  return {
      {"vulkan-facing-exchanged", "front is the other side, for all triangles", "",
       Exchanged("vulkan")},
      {"d3d11-facing-exchanged", "front is the other side, for all triangles", "",
       Exchanged("d3d11")},
      {"webgpu-facing-exchanged", "front is the other side, for all triangles", "",
       Exchanged("webgpu")},
      {"vulkan-facing-4-bits", "facing is that of the vertices on a grid of four bits", "",
       Facing("vulkan",
              [](GridTriangle& t) {
                std::vector<GridPoint> coarse;
                for (const GridPoint p : t.v) coarse.push_back(OnCoarseGrid(p));
                FaceBy(DoubledArea(coarse), t);
              })},
      {"vulkan-facing-clipped", "facing is that of the polygon clipped to the target", "",
       OfTheClippedPolygon("vulkan")},
      {"vulkan-facing-of-input", "facing is that of the vertices as given", "",
       FacingBeforeTheSnap(StagesOfPreset("vulkan"))},
      {"d3d11-facing-clipped", "facing is that of the polygon clipped to the target", "",
       OfTheClippedPolygon("d3d11")},
  };
}

std::vector<Mutant> FacingMutants() {
  return {
      {"facing-of-input", "facing is the sign of the area before the snap", "",
       FacingBeforeTheSnap({}), "facing|facing-arithmetic",
       "CoverageEqualsTheModel|FacingIsOneAtAllSamples|SignedCoverageEqualsTheWindingNumber"},
      {"culls-of-input", "triangles are culled by the area before the snap",
       "D3D11.3 culls after it", CullingBeforeTheSnap({}), "", "CullingRemovesOneFacing"},
      {"d3d11-facing-of-input", "facing is the sign of the area before the snap", "",
       FacingBeforeTheSnap(StagesOfPreset("d3d11")), "", "FacingIsOneAtAllSamples"},
      {"d3d11-culls-of-input", "triangles are culled by the area before the snap", "",
       CullingBeforeTheSnap(StagesOfPreset("d3d11")), "", "CullingRemovesOneFacing"},
      {"vulkan-facing-by-hash", "a hash of its vertices decides which side a triangle shows", "",
       Facing("vulkan", [](GridTriangle& t) { t.front = CoinOf(t); })},
      {"d3d11-facing-by-hash", "a hash of its vertices decides which side a triangle shows", "",
       Facing("d3d11", [](GridTriangle& t) { t.front = CoinOf(t); })},
      {"vulkan-facing-by-place", "every other triangle of a call shows its other side", "",
       Facing("vulkan",
              [](GridTriangle& t) {
                if (t.number % 2 == 1) t.front = !t.front;
              }),
       "list"},
      {"vulkan-facing-by-call", "in every other call triangles show their other sides", "",
       ExchangedInEveryOtherCall("vulkan"), "earlier-draws"},
      {"vulkan-facing-by-target", "on targets of odd width triangles show their other sides", "",
       ExchangedOnTargetsOfOddWidth("vulkan")},
      {"vulkan-culls-the-other", "some triangles are culled with the other side", "",
       CullingTheOtherSide("vulkan"), "culling"},
  };
}

}  // namespace

extern constinit const MutantTable kFacingVariants{MutantKind::kLegal, 10, FacingVariants};
extern constinit const MutantTable kFacingMutants{MutantKind::kPlanted, 18, FacingMutants};

}  // namespace rasterproof::subjects::mutants
