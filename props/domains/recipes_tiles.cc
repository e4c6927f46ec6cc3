// Edges on the borders of a rasterizer's tiles, whatever the size of these, and beside them.
#include <array>
#include <cstdint>
#include <span>

#include "props/domains/case_builder.h"
#include "props/domains/lines.h"
#include "props/domains/recipes.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 5> kTileSides{4, 8, 16, 32, 64};

// A border of tiles; a step beside it; or the last sample before it, the first one after it, or a
// step beside these. Along x; along y if `along_y`.
double DrawBorder(CaseBuilder& builder, int tile, bool along_y) {
  BitSource& bits = builder.bits();
  const int extent = along_y ? builder.height() : builder.width();
  double place = tile * static_cast<double>(bits.Int(0, extent / tile + 1));
  if (bits.Chance(128)) {
    const Point2 sample = bits.OneOf(std::span<const Point2>(builder.profile().pattern.locations));
    place += (along_y ? sample.y : sample.x) - (bits.Chance(128) ? 1 : 0);
  }
  place = builder.lattice().RoundWithinLimit(place);
  return bits.Chance(128) ? builder.lattice().Move(place, bits.Int(-1, 1)) : place;
}

// Half of the boxes are a pixel high or wide, or a pixel and a step.
void AddBox(CaseBuilder& builder, int tile) {
  BitSource& bits = builder.bits();
  const Point2 a{DrawBorder(builder, tile, false), DrawBorder(builder, tile, true)};
  Point2 b{DrawBorder(builder, tile, false), DrawBorder(builder, tile, true)};
  const std::int64_t thin = bits.Int(0, 3);
  const double thickness = builder.Sign();
  if (thin == 0) b.x = builder.lattice().RoundWithinLimit(a.x + thickness);
  if (thin == 1) b.y = builder.lattice().RoundWithinLimit(a.y + thickness);
  if (thin < 2 && bits.Chance(64)) b = Nudged(builder, b, 1);
  builder.AddTriangle({a, Point2{b.x, a.y}, b});
  if (bits.Chance(192)) builder.AddTriangle({a, b, Point2{a.x, b.y}});
}

}  // namespace

Case TileBorders(BitSource& bits, const SubjectInfo& info) {
  const int tile = bits.OneOf(std::span<const int>(kTileSides));
  const auto draw_extent = [&] {
    const std::int64_t tiles = bits.Int(1, tile < 32 ? 3 : 1);
    return static_cast<int>(tile * tiles + bits.Int(0, 5));
  };
  const int width = draw_extent();
  CaseBuilder builder(bits, info, width, draw_extent());
  const std::int64_t shapes = bits.Int(1, 4);
  for (std::int64_t i = 0; i < shapes; ++i) {
    if (bits.Chance(128)) {
      AddBox(builder, tile);
      continue;
    }
    std::array<Point2, 3> corners;
    for (Point2& p : corners) {
      p = {DrawBorder(builder, tile, false), DrawBorder(builder, tile, true)};
    }
    builder.AddTriangle(corners);
  }
  const bool states_tile = bits.Chance(128) && info.takes_tiles;
  Case c = builder.Done(Finish::kAnyOrder);
  if (states_tile) c.options.tile = tile;
  return c;
}

}  // namespace rasterproof::props
