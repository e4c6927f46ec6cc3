// Bugs in how the samples of a triangle are found: its box, its tiles, its stepping.
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Corners3 = std::array<TileCorners, 3>;

FixedStages Boxing(void (*box)(PixelRect&)) {
  return {{.box = [box](PixelRect& rect, const GridTriangle&, const Scene&) { box(rect); }}};
}
FixedStages Testing(TileTest (*test)(const Corners3&, TileTest sound)) {
  return {{.tile_test = test}};
}

bool AllEdges(const Corners3& values, bool (*holds)(const TileCorners&)) {
  return std::ranges::all_of(values, holds);
}

std::vector<Mutant> Boxes() {
  return {
      {"box-left", "the box begins one pixel late", "", Boxing([](PixelRect& b) { ++b.x0; }),
       "bounding-box"},
      {"box-right", "the box ends one pixel early", "", Boxing([](PixelRect& b) { --b.x1; }),
       "bounding-box"},
      {"box-top", "the box begins one row late", "", Boxing([](PixelRect& b) { ++b.y0; }),
       "bounding-box"},
      {"box-bottom", "the box ends one row early", "", Boxing([](PixelRect& b) { --b.y1; }),
       "bounding-box"},
      {"box-single-column", "a box of one column is taken for empty", "", Boxing([](PixelRect& b) {
         if (b.x1 - b.x0 == 1) b.x1 = b.x0;
       }),
       "bounding-box"},
      {"box-of-centres", "the box is of pixels whose centre it holds, strictly", "euc #17",
       FixedStages{{.box =
                        [](PixelRect& b, const GridTriangle& t, const Scene&) {
                          const auto [left, right] = std::ranges::minmax(t.v, {}, &GridPoint::x);
                          b.x0 = static_cast<int>((left.x + 128) >> 8);
                          b.x1 = static_cast<int>((right.x + 127) >> 8);
                        }}},
       "bounding-box"},
      {"box-limited-by-last", "the box ends no farther right than that of the triangle before", "",
       FixedStages{
           {.box =
                [last = PixelRect{}](PixelRect& b, const GridTriangle& t, const Scene&) mutable {
                  if (t.number != 0) b.x1 = std::min(b.x1, std::max(last.x1, b.x0 + 4));
                  last = b;
                }}},
       "list", "TriangleOrderKeepsCoverage"},
  };
}

// The largest of an edge's values, where it is lost in the rounding of a sum of 30 bits.
bool IsLostInTheLargest(const TileCorners& e) {
  const auto [least, most] = std::ranges::minmax(e);
  return least < 0 && most > 0 && most <= -(least >> 30);
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> Tiles() {
  return {
      {"tile-reject-rounded", "a tile is rejected by an edge's values rounded to 30 bits", "",
       Testing([](const Corners3& values, TileTest sound) {
         return std::ranges::any_of(values, IsLostInTheLargest) ? TileTest::kOutside : sound;
       })},
      {"tile-accept-one-corner", "a tile is accepted if its first corner is inside", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return e[0] > 0; }) ? TileTest::kInside
                                                                                : sound;
       }),
       "tile-borders"},
      {"tile-accept-two-corners", "a tile is accepted if two opposite corners are inside", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return e[0] > 0 && e[3] > 0; })
                    ? TileTest::kInside
                    : sound;
       }),
       "tile-borders"},
      {"tile-accept-ties", "a tile with a corner exactly on an edge is accepted", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return std::ranges::min(e) >= 0; })
                    ? TileTest::kInside
                    : sound;
       })},
      {"tile-accept-off-by-one", "a tile is accepted from an edge value of -1 on", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return std::ranges::min(e) >= -1; })
                    ? TileTest::kInside
                    : sound;
       })},
      {"tile-reject-one-corner", "a tile is rejected if its first corner is outside an edge", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return e[0] >= 0; })
                    ? sound
                    : TileTest::kOutside;
       }),
       "tile-borders"},
      {"tile-reject-ties", "a tile that only touches an edge is rejected", "",
       Testing([](const Corners3& values, TileTest sound) {
         return AllEdges(values, [](const TileCorners& e) { return std::ranges::max(e) > 0; })
                    ? sound
                    : TileTest::kOutside;
       })},
      {"tile-reject-all-corners", "a tile is rejected if no corner is inside the triangle", "",
       Testing([](const Corners3& values, TileTest sound) {
         for (std::size_t corner = 0; corner < 4; ++corner) {
           if (std::ranges::all_of(values, [&](const TileCorners& e) { return e[corner] >= 0; })) {
             return sound;
           }
         }
         return TileTest::kOutside;
       }),
       "tile-borders"},
      {"tile-size-matters", "tiles of more than 32 pixels leave out the target's first row", "",
       FixedStages{{.options =
                        [](DrawOptions& options, const Scene& scene) {
                          if (options.tile > 32)
                            options.scissor = PixelRect{0, 1, scene.width, scene.height};
                        }}},
       "tile-size", "TileSizeKeepsCoverage"},
      {"tile-odd-size", "tiles whose side is no power of two leave out their first column", "",
       FixedStages{{.options =
                        [](DrawOptions& options, const Scene& scene) {
                          const int side = std::max(1, options.tile);
                          if ((side & (side - 1)) != 0 && scene.width > side) {
                            options.scissor = PixelRect{side, 0, scene.width, scene.height};
                          }
                        }}},
       "tile-size"},
      {"tile-seams", "samples in the first column of a tile are counted twice", "",
       FixedStages{
           {.times = [](const Sample& at,
                        const GridTriangle&) { return at.x % 8 == 0 && at.x > 0 ? 2U : 1U; }}},
       "tile-borders"},
  };
}

// An edge stepped along a row, from the left end of a tile of 64 pixels, in float32 steps.
std::int64_t SteppedInFloat(const GridEdge& e, const Sample& at) {
  const int steps = at.x % 64;
  const std::int64_t pixel = 256;
  float value = static_cast<float>(e.At({at.at.x - steps * pixel, at.at.y}));
  const float step = static_cast<float>(e.b.y - e.a.y) * static_cast<float>(pixel);
  for (int n = 0; n < steps; ++n) value += step;
  return std::int64_t{(value > 0) - (value < 0)};
}

std::int64_t SteppedIn16Bits(const GridEdge& e, const Sample& at) {
  const std::int64_t dy = e.b.y - e.a.y;
  return e.At(at.at) + (at.x % 8) * 256 * (static_cast<std::int16_t>(dy) - dy);
}

FixedStages SteppingOfTheVulkanSet(double limit) {
  FixedStages stages = StagesOfPreset("vulkan");
  stages.profile.coordinate_limit = limit;
  stages.value = SteppedIn16Bits;
  return stages;
}

std::vector<Mutant> Stepping() {
  return {
      {"stepping-drifts", "stepping along a row adds up in float32", "gogpu/gg #127",
       FixedStages{{.value = SteppedInFloat}}, "float-edges"},
      {"stepping-step-x", "the step along x is off by one unit", "",
       FixedStages{{.value = [](const GridEdge& e,
                                const Sample& at) { return e.At(at.at) + (at.x % 8); }}}},
      {"stepping-step-y", "the step along y is off by one unit", "",
       FixedStages{{.value = [](const GridEdge& e,
                                const Sample& at) { return e.At(at.at) - (at.row % 8); }}}},
      {"stepping-16-bit-slope", "the slope per pixel is kept in 16 bits", "",
       FixedStages{{.value = SteppedIn16Bits}}},
      {"stepping-16-bit-slope-far", "the same, of the Vulkan set, with a limit of 2^30 pixels", "",
       SteppingOfTheVulkanSet(0x1p30)},
  };
}

std::vector<Mutant> TraversalMutants() {
  std::vector<Mutant> table = Boxes();
  for (Mutant& planted : Tiles()) table.push_back(std::move(planted));
  for (Mutant& planted : Stepping()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kTraversalMutants{MutantKind::kPlanted, 4, TraversalMutants};

}  // namespace rasterproof::subjects::mutants
