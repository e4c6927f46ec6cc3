// Bugs in triangle set-up: numbers that wrap, clamp or lose bits, and what is done to far vertices.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// Two's complement, as C++20 has it.
std::int64_t Wrapped16(std::int64_t n) { return static_cast<std::int16_t>(n); }
std::int64_t Wrapped32(std::int64_t n) { return static_cast<std::int32_t>(n); }
std::int64_t Wrapped48(std::int64_t n) { return (n << 16) >> 16; }

FixedStages Placing(void (*place)(GridPoint&)) {
  return {{.place = [place](GridPoint& p, const Scene&) { place(p); }}};
}
FixedStages Valuing(std::int64_t (*value)(const GridEdge&, GridPoint)) {
  return {{.value = [value](const GridEdge& e, const Sample& at) { return value(e, at.at); }}};
}
void ClampTo(GridPoint& p, std::int64_t least, std::int64_t most) {
  p = {std::clamp(p.x, least, most), std::clamp(p.y, least, most)};
}

std::vector<Mutant> Overflows() {
  return {
      {"overflow-int16-coordinates", "coordinates wrap at 128 pixels: int16 in 1/256 pixel",
       "keeperfx #4668", Placing([](GridPoint& p) { p = {Wrapped16(p.x), Wrapped16(p.y)}; }),
       "overflow"},
      {"overflow-unsigned", "negative coordinates wrap to the far end", "Citra #1633",
       Placing([](GridPoint& p) { p = {p.x & 0xffffff, p.y & 0xffffff}; }), "overflow"},
      {"overflow-int16-deltas", "edge deltas wrap at 128 pixels", "Adafruit-GFX #164",
       Valuing([](const GridEdge& e, GridPoint p) {
         return (p.x - e.a.x) * Wrapped16(e.b.y - e.a.y) - (p.y - e.a.y) * Wrapped16(e.b.x - e.a.x);
       }),
       "overflow"},
      {"overflow-int32-edges", "edge values wrap at 2^31", "SwiftShader bd85ab2, llvmpipe 1165ff1",
       Valuing([](const GridEdge& e, GridPoint p) { return Wrapped32(e.At(p)); }), "overflow"},
      {"overflow-int32-area", "the area wraps at 2^31", "SwiftShader 3424b10",
       FixedStages{{.area =
                        [](const std::array<GridPoint, 3>& v) {
                          return Wrapped32(GridEdge{v[0], v[1]}.At(v[2]));
                        }}},
       "overflow"},
      {"overflow-48-bits", "edge values wrap at 2^47", "",
       Valuing([](const GridEdge& e, GridPoint p) { return Wrapped48(e.At(p)); }), "overflow"},
      {"overflow-one-product", "one product of the two wraps at 2^31", "HarfBuzz #6153",
       Valuing([](const GridEdge& e, GridPoint p) {
         return (p.x - e.a.x) * (e.b.y - e.a.y) - Wrapped32((p.y - e.a.y) * (e.b.x - e.a.x));
       }),
       "overflow"},
      {"values-shifted", "edge values lose their last four bits before the test", "",
       Valuing([](const GridEdge& e, GridPoint p) { return e.At(p) >> 4; }), "edge-precision"},
      {"values-in-float", "edge values are rounded to float32 term by term", "",
       Valuing([](const GridEdge& e, GridPoint p) {
         const auto f = [](std::int64_t n) { return static_cast<float>(n); };
         const float constant = f(e.a.y) * f(e.b.x) - f(e.a.x) * f(e.b.y);
         const float value = f(e.b.y - e.a.y) * f(p.x) - f(e.b.x - e.a.x) * f(p.y) + constant;
         return std::int64_t{(value > 0) - (value < 0)};
       }),
       "float-edges"},
  };
}

// The vertices farther than the guard band, pulled in along the edge from the first vertex: each of
// two neighbours bends the edge that they share in its own way.
void PullIn(std::array<Vertex, 3>& v) {
  constexpr double kBand = 0x1p12;
  for (std::size_t i = 1; i < 3; ++i) {
    const double reach = std::max(std::fabs(v[i].x), std::fabs(v[i].y));
    if (!(reach > kBand) || !std::isfinite(reach)) continue;
    const double part = kBand / reach;
    v[i].x = v[0].x + part * (v[i].x - v[0].x);
    v[i].y = v[0].y + part * (v[i].y - v[0].y);
  }
}

std::vector<Mutant> FarVertices() {
  return {
      {"clamp-12.4", "coordinates are clamped to what 12.4 bits hold",
       "passes the published conformance checks",
       Placing([](GridPoint& p) { ClampTo(p, -2048 * 256, 2048 * 256 - 16); }), "range"},
      {"clamp-to-coordinate-limit", "vertices are clamped to +-8192 pixels", "",
       Placing([](GridPoint& p) { ClampTo(p, -8192 * 256, 8192 * 256); }), "range"},
      {"clip-unlike-neighbours", "far vertices are pulled in along the edges of the first vertex",
       "nvdiffrast #225", FixedStages{{.vertices = PullIn}}},
      {"drop-beyond-coordinate-limit", "a triangle with a vertex beyond 16384 pixels is dropped",
       "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(
                              Corners(scene, scene.triangles[number]), [](const Vertex& v) {
                                return std::fabs(v.x) > 0x1p14 || std::fabs(v.y) > 0x1p14;
                              });
                        }}},
       "lost-triangles"},
      {"drop-left-of-target", "a triangle with a vertex left of -1 pixel is dropped", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(Corners(scene, scene.triangles[number]),
                                                     [](const Vertex& v) { return v.x < -1; });
                        }}},
       "lost-triangles", "IntegerTranslationMovesCoverage|NeighboursAreClippedAlike"},
      {"drop-at-the-limit", "a coordinate at the limit itself counts as beyond it", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(
                              Corners(scene, scene.triangles[number]), [](const Vertex& v) {
                                return std::fabs(v.x) >= 0x1p15 || std::fabs(v.y) >= 0x1p15;
                              });
                        }}},
       "lost-triangles"},
      {"cracks-far-off", "edges longer than 2^14 pixels are walked with slopes of 16 bits", "",
       Valuing([](const GridEdge& e, GridPoint p) {
         const std::int64_t dx = e.b.x - e.a.x;
         const std::int64_t dy = e.b.y - e.a.y;
         const bool is_long = std::max(std::abs(dx), std::abs(dy)) > (std::int64_t{1} << 22);
         const auto coarse = [&](std::int64_t d) { return is_long ? d / 256 * 256 : d; };
         return (p.x - e.a.x) * coarse(dy) - (p.y - e.a.y) * coarse(dx);
       })},
  };
}

std::vector<Mutant> SetUpMutants() {
  std::vector<Mutant> table = Overflows();
  for (Mutant& planted : FarVertices()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kSetUpMutants{MutantKind::kPlanted, 3, SetUpMutants};

}  // namespace rasterproof::subjects::mutants
