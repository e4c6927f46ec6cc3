// Bugs in the way from a map to the target and to its tiles, and ways that keep their contract.
#include <cmath>
#include <vector>

#include "core/snap.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

// The size of UTM coordinates, whose last bits are 2^-33 and 2^-30 metres.
constexpr double kEast = 872512;
constexpr double kNorth = 6114970;

constexpr Transform MapOf(double step, Division division) {
  return {.precision = Precision::kFloat64,
          .division = division,
          .map = MapGrid{kEast, kNorth, step, -step}};
}

constexpr Transform kTenths = MapOf(0.1, Division::kQuotient);
// A whole number of metres whose float64 reciprocal takes places off the grid; 1 / 30 does not.
constexpr Transform kSeventyFives = MapOf(75, Division::kQuotient);
constexpr Transform kThirds = MapOf(1.0 / 3, Division::kReciprocal);

// As the stated operations say, written out once more.
Point2 ByQuotient(const Vertex& v, const MapGrid& map) {
  return {(v.x - map.x0) / map.dx, (v.y - map.y0) / map.dy};
}

Point2 ByReciprocal(const Vertex& v, const MapGrid& map) {
  return {(v.x - map.x0) * (1 / map.dx), (v.y - map.y0) * (1 / map.dy)};
}

using Form = Point2 (*)(const Vertex&, const MapGrid&);

// Vertices are placed once, on the whole target, and moved by whole pixels: exact on the grid.
TransformStages ShiftedTiles(const Transform& stated, Form form) {
  TransformStages stages;
  stages.stated = stated;
  stages.to_tile = [stated, form](const Vertex& v, const PixelRect& tile) {
    const Snap grid = FixedPointProfile().snap;
    const Point2 p = form(v, *stated.map);
    return Point2{SnapToGrid(p.x, grid) - tile.x0, SnapToGrid(p.y, grid) - tile.y0};
  };
  return stages;
}

// Places vertices relative to the tile's own origin.
template <class Origin>
TransformStages FromItsOwnOrigin(const Transform& stated, Form form, Origin origin) {
  TransformStages stages;
  stages.stated = stated;
  stages.to_tile = [stated, form, origin](const Vertex& v, const PixelRect& tile) {
    MapGrid map = *stated.map;
    map.x0 = origin(map.x0, map.dx, tile.x0);
    map.y0 = origin(map.y0, map.dy, tile.y0);
    return form(v, map);
  };
  return stages;
}

double OriginByProduct(double origin, double step, int pixels) { return origin + pixels * step; }

double OriginBySum(double origin, double step, int pixels) {
  for (int k = 0; k < pixels; ++k) origin += step;
  return origin;
}

std::vector<Mutant> MapMutants() {
  return {
      {"map-tile-origin", "a tile places vertices from its own origin, x0 + i dx, rounded", "",
       FromItsOwnOrigin(kTenths, ByQuotient, OriginByProduct), "scissor",
       "TilesDrawnApartEqualTheWhole"},
      {"map-tile-origin-reciprocal", "the same, times 1 / dx, of a third of a metre", "",
       FromItsOwnOrigin(kThirds, ByReciprocal, OriginByProduct), "scissor"},
      {"map-tile-origin-summed", "a tile's origin is dx added up pixel by pixel", "",
       FromItsOwnOrigin(kTenths, ByQuotient, OriginBySum), "scissor"},
      {"map-reciprocal", "x - x0 is multiplied by 1 / 75 where it is to be divided by 75", "",
       ShiftedTiles(kSeventyFives, ByReciprocal), "transform"},
      {"map-scaled-first", "x and x0 are divided by dx before they are subtracted", "",
       ShiftedTiles(kTenths,
                    [](const Vertex& v, const MapGrid& map) {
                      return Point2{v.x / map.dx - map.x0 / map.dx, v.y / map.dy - map.y0 / map.dy};
                    }),
       "transform"},
      {"map-in-float32", "a map's coordinates are rounded to float32", "",
       ShiftedTiles(kTenths,
                    [](const Vertex& v, const MapGrid& map) {
                      const Vertex rounded{static_cast<float>(v.x), static_cast<float>(v.y), v.z,
                                           1};
                      return ByQuotient(rounded, map);
                    }),
       "transform"},
  };
}

std::vector<Mutant> MapVariants() {
  return {
      {"map-quotient", "a map in float64, divided by a tenth; tiles are moved by whole pixels", "",
       ShiftedTiles(kTenths, ByQuotient)},
      {"map-reciprocal", "a map in float64, times the reciprocal of a third; tiles likewise", "",
       ShiftedTiles(kThirds, ByReciprocal)},
      {"map-quarter", "a map in float64, divided by a quarter: every tile's origin is exact", "",
       FromItsOwnOrigin(MapOf(0.25, Division::kQuotient), ByQuotient, OriginByProduct)},
  };
}

}  // namespace

extern constinit const MutantTable kMapMutants{MutantKind::kPlanted, 11, MapMutants};
extern constinit const MutantTable kMapVariants{MutantKind::kLegal, 3, MapVariants};

}  // namespace rasterproof::subjects::mutants
