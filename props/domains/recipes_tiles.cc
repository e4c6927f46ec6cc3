// Edges on the borders of a rasterizer's tiles, whatever the size of these, and beside them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

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

// The outermost sample of a tile in one of its corners, or the corner itself, and which way the
// tile lies from it.
struct TileCorner {
  Point2 at;
  Point2 inward;
};

TileCorner DrawTileCorner(CaseBuilder& builder, int tile) {
  BitSource& bits = builder.bits();
  const bool right = bits.Chance(128);
  const bool bottom = bits.Chance(128);
  const auto first = [&](int extent) {
    return tile * static_cast<int>(bits.Int(0, std::max(0, extent / tile - 1)));
  };
  const int i = first(builder.width());
  const int j = first(builder.height());
  const Point2 inward{right ? -1.0 : 1.0, bottom ? -1.0 : 1.0};
  const Point2 corner{static_cast<double>(i + (right ? tile : 0)),
                      static_cast<double>(j + (bottom ? tile : 0))};
  if (bits.Chance(48)) return {corner, inward};
  const Point2 location = bits.OneOf(std::span<const Point2>(builder.profile().pattern.locations));
  return {{corner.x + location.x - (right ? 1 : 0), corner.y + location.y - (bottom ? 1 : 0)},
          inward};
}

// An edge past the corner, across the tile's diagonal there, so that no other sample of the tile is
// as near; from far off to far off, and as near to the corner as the lattice allows, or through it.
// The third vertex is away from the tile, which then has that corner alone, or beyond it.
void AddTrianglePast(CaseBuilder& builder, const TileCorner& corner) {
  BitSource& bits = builder.bits();
  const int most = std::max(7, std::ilogb(builder.Range()) - 1);
  const double far = std::fabs(builder.LogUniform(std::min(11, most - 1), most - 1));
  const double slope = builder.Uniform(0.125, 1);
  const bool is_steep = bits.Chance(128);
  const Point2 along{corner.inward.x * (is_steep ? slope : 1),
                     -corner.inward.y * (is_steep ? 1 : slope)};
  const auto beyond = [&](double times) {
    return Point2{corner.at.x + times * along.x, corner.at.y + times * along.y};
  };
  const double back = -far * builder.Uniform(0.25, 1);
  const Point2 a = OnLattice(builder, beyond(far));
  const Point2 b = OnLattice(builder, Hardest(builder, beyond(back), a, corner.at));
  const double away = (bits.Chance(192) ? -1 : 1) * far * builder.Uniform(0.25, 1);
  const Point2 third{corner.at.x + away * corner.inward.x, corner.at.y + away * corner.inward.y};
  builder.AddTriangle({a, b, third});
}

}  // namespace

static Case TileBorders(BitSource& bits, const SubjectInfo& info) {
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

extern constinit const Domain kTileBordersDomain{
    .number = 76,
    .bits = 0x68ed867fed5683a4,
    .name = "tile-borders",
    .summary = "edges on multiples of 4 to 64 pixels and beside, boxes a pixel thick",
    .theme = DomainTheme::kCalls,
    .in_theme = 861,
    .draw = TileBorders};

static Case FarTileCorners(BitSource& bits, const SubjectInfo& info) {
  const int tile = bits.OneOf(std::span<const int>(kTileSides));
  const auto draw_extent = [&] {
    return static_cast<int>(tile * bits.Int(1, std::max(1, 48 / tile)));
  };
  const int width = draw_extent();
  CaseBuilder builder(bits, info, width, draw_extent());
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    AddTrianglePast(builder, DrawTileCorner(builder, tile));
  }
  const bool states_tile = bits.Chance(128) && info.takes_tiles;
  Case c = builder.Done(Finish::kAnyOrder);
  if (states_tile) c.options.tile = tile;
  return c;
}

extern constinit const Domain kFarTileCornersDomain{
    .number = 87,
    .bits = 0x1b676092fe08e0ae,
    .name = "far-tile-corners",
    .summary = "edges from far off that pass the corner of a tile as near as can be",
    .theme = DomainTheme::kCalls,
    .draw = FarTileCorners};

}  // namespace rasterproof::props
