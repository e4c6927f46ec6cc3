// Bugs in how triangles are taken: state that leaks, input that is no triangle, samples that are
// lost.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Drops = bool (*)(const std::array<Vertex, 3>&);
FixedStages Dropping(Drops drops) {
  return {{.drops = [drops](const Scene& scene, std::size_t number) {
    return drops(Corners(scene, scene.triangles[number]));
  }}};
}

double Extent(double a, double b, double c) { return std::max({a, b, c}) - std::min({a, b, c}); }
double TwiceArea(const std::array<Vertex, 3>& v) {
  return std::fabs((v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x));
}
bool HasNan(const std::array<Vertex, 3>& v) {
  return std::ranges::any_of(v, [](const Vertex& p) { return std::isnan(p.x) || std::isnan(p.y); });
}

// Replaces what is no number, so that the triangle is drawn.
FixedStages Taking(double (*number)(double)) {
  return {{.vertices = [number](std::array<Vertex, 3>& v) {
    for (Vertex& p : v) p = {number(p.x), number(p.y), p.z, p.w};
  }}};
}

// A hash of the sample and the triangle that is equally often below any share.
std::uint64_t HashOf(const Sample& at, const GridTriangle& t) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const std::int64_t n : {at.at.x, at.at.y, std::int64_t{at.s}, t.v[0].x, t.v[0].y, t.v[1].x,
                               t.v[1].y, t.v[2].x, t.v[2].y}) {
    hash = (hash ^ static_cast<std::uint64_t>(n)) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return hash;
}
FixedStages LosingOneIn(std::uint64_t n) {
  return {{.times = [n](const Sample& at, const GridTriangle& t) {
    return HashOf(at, t) % n == 0 ? 0U : 1U;
  }}};
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> Leaks() {
  return {
      {"leak-owner", "the first edge owns its samples as that of the triangle before did", "",
       FixedStages{{.edges =
                        [last = true](GridTriangle& t) mutable {
                          const bool own = t.edges[0].owns;
                          if (t.number != 0) t.edges[0].owns = last;
                          last = own;
                        }}},
       "list"},
      {"leak-facing", "a triangle that shares its first vertex with the last one faces as it did",
       "",
       FixedStages{{.facing =
                        [last = GridTriangle{}](GridTriangle& t) mutable {
                          const bool shares = t.number != 0 && t.indices[0] == last.indices[0];
                          const bool front = t.front;
                          if (shares) t.front = last.front;
                          last = t;
                          last.front = front;
                        }}},
       "list"},
      {"leak-repeated", "a triangle with the vertices of the one before is not drawn", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          if (number == 0) return false;
                          Triangle a = scene.triangles[number - 1];
                          Triangle b = scene.triangles[number];
                          std::ranges::sort(a);
                          std::ranges::sort(b);
                          return a == b;
                        }}},
       "list"},
      {"leak-after-degenerate", "the triangle after one without area is not drawn", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return number != 0 &&
                                 TwiceArea(Corners(scene, scene.triangles[number - 1])) == 0;
                        }}},
       "list"},
      {"leak-set-up", "the set-up before is used again if five of six coordinates agree", "",
       FixedStages{{.edges =
                        [last = GridTriangle{}](GridTriangle& t) mutable {
                          const bool agrees = t.number != 0 && t.v[0].x == last.v[0].x &&
                                              t.v[0].y == last.v[0].y && t.v[1].x == last.v[1].x &&
                                              t.v[1].y == last.v[1].y && t.v[2].x == last.v[2].x;
                          if (agrees) t.edges = last.edges;
                          last = t;
                        }}},
       "list"},
      {"leak-after-wide", "what goes on from a triangle of over 1024 pixels is lost with it", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          if (number == 0) return false;
                          const Triangle& last = scene.triangles[number - 1];
                          const Triangle& t = scene.triangles[number];
                          const std::array<Vertex, 3> v = Corners(scene, last);
                          return t[0] == last[1] && t[1] == last[2] &&
                                 Extent(v[0].x, v[1].x, v[2].x) > 1024;
                        }}},
       "list"},
      {"many-lost", "triangles from 256 on are lost", "",
       FixedStages{{.drops = [](const Scene&, std::size_t number) { return number >= 256; }}},
       "lost-triangles", "OneCallDrawsLikeItsTriangles"},
      {"many-vertices-lost", "triangles with vertices from 256 on are lost", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(scene.triangles[number],
                                                     [](std::int32_t i) { return i >= 256; });
                        }}},
       "lost-triangles"},
      {"leak-cached-vertex", "vertices 65, 129, ... are lost from the cache, with their triangles",
       "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(scene.triangles[number], [](std::int32_t i) {
                            return i >= 64 && i % 64 == 1;
                          });
                        }}},
       "", "DuplicatedVerticesKeepCoverage"},
  };
}

std::vector<Mutant> Batches() {
  return {
      {"batch-last-lost", "the last scene of a batch is not drawn", "",
       FixedStages{{.batch =
                        [](std::vector<DrawOutcome>& outcomes) {
                          CoverageCounts& last = outcomes.back().drawing.counts;
                          last = CoverageCounts(last.width, last.height, last.samples);
                        }}},
       "earlier-draws", "BatchDrawsLikeSingleCalls"},
      {"batch-leaks", "what a scene of a batch covers stays in the next one of its size", "",
       FixedStages{{.batch =
                        [](std::vector<DrawOutcome>& outcomes) {
                          for (std::size_t k = 1; k < outcomes.size(); ++k) {
                            const CoverageCounts& before = outcomes[k - 1].drawing.counts;
                            CoverageCounts& counts = outcomes[k].drawing.counts;
                            if (before.size() == counts.size()) counts += before;
                          }
                        }}},
       "earlier-draws", "BatchDrawsLikeSingleCalls"},
  };
}

std::vector<Mutant> BadInput() {
  return {
      {"nan-as-zero", "NaN is taken for zero, and the triangle drawn", "",
       Taking([](double x) { return std::isnan(x) ? 0.0 : x; }), "not-finite",
       "NonFiniteTrianglesCoverNothing"},
      {"nan-by-comparison", "min and max leave NaN out, and the triangle is drawn", "",
       Taking([](double x) { return std::isnan(x) ? 64.0 : x; }), "not-finite"},
      {"infinity-clamped", "infinity is clamped to the limit, and the triangle drawn", "",
       Taking([](double x) { return std::isinf(x) ? std::copysign(0x1p15, x) : x; }), "not-finite"},
      {"nan-poisons", "nothing is drawn after a triangle with NaN", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          for (std::size_t t = 0; t < number; ++t) {
                            if (HasNan(Corners(scene, scene.triangles[t]))) return true;
                          }
                          return false;
                        }}},
       "list|not-finite", "BadTrianglesPoisonNoOthers"},
      {"degenerate-line", "a triangle without area is drawn as a line", "",
       FixedStages{{.area =
                        [](const std::array<GridPoint, 3>& v) {
                          const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
                          return area == 0 ? 1 : area;
                        },
                    .owns = OwnsIfFlat}},
       "flat-triangles", "DegenerateTrianglesCoverNothing"},
      {"degenerate-repeated-index", "a repeated vertex is drawn as if it were two pixels away", "",
       FixedStages{{.vertices =
                        [](std::array<Vertex, 3>& v) {
                          if (v[0] == v[1]) v[1].x += 2;
                        }}}},
  };
}

std::vector<Mutant> Losses() {
  return {
      {"lost-1-in-1e4", "one sample in 10^4 is not drawn", "", LosingOneIn(10'000)},
      {"lost-1-in-1e6", "one sample in 10^6 is not drawn", "", LosingOneIn(1'000'000)},
      {"lost-small", "triangles of less than a pixel's area are culled",
       "passes the published conformance checks",
       Dropping([](const std::array<Vertex, 3>& v) { return TwiceArea(v) < 2; }), "lost-triangles"},
      {"lost-small-box", "triangles whose box is smaller than a pixel are culled", "",
       Dropping([](const std::array<Vertex, 3>& v) {
         return Extent(v[0].x, v[1].x, v[2].x) < 1 && Extent(v[0].y, v[1].y, v[2].y) < 1;
       }),
       "lost-triangles"},
      {"lost-thin", "triangles thinner than 1/16 pixel are culled", "",
       Dropping([](const std::array<Vertex, 3>& v) {
         const double length =
             std::max(Extent(v[0].x, v[1].x, v[2].x), Extent(v[0].y, v[1].y, v[2].y));
         return TwiceArea(v) < length / 16;
       }),
       "lost-triangles"},
      {"lost-huge", "triangles of more than 8192 pixels a side are not drawn",
       "passes the published conformance checks", Dropping([](const std::array<Vertex, 3>& v) {
         return std::max(Extent(v[0].x, v[1].x, v[2].x), Extent(v[0].y, v[1].y, v[2].y)) > 8192;
       }),
       "lost-triangles"},
      {"lost-after-64", "the triangles of a scene from the 65th on are not drawn", "",
       FixedStages{{.drops = [](const Scene&, std::size_t number) { return number >= 64; }}},
       "lost-triangles"},
      {"lost-at-vertices", "a sample exactly on a vertex is not drawn", "",
       FixedStages{{.times =
                        [](const Sample& at, const GridTriangle& t) {
                          return std::ranges::any_of(t.v,
                                                     [&](const GridPoint& p) {
                                                       return p.x == at.at.x && p.y == at.at.y;
                                                     })
                                     ? 0U
                                     : 1U;
                        }}},
       "vertices"},
      {"doubled-on-middle-line", "samples level with the middle vertex are counted twice",
       "triangles that are drawn in an upper and a lower half",
       FixedStages{{.times =
                        [](const Sample& at, const GridTriangle& t) {
                          const std::int64_t middle =
                              std::max(std::min(t.v[0].y, t.v[1].y),
                                       std::min(std::max(t.v[0].y, t.v[1].y), t.v[2].y));
                          const bool is_split = std::ranges::count(t.v, middle, &GridPoint::y) == 1;
                          return is_split && at.at.y == middle ? 2U : 1U;
                        }}},
       "counting"},
  };
}

std::vector<Mutant> SceneMutants() {
  std::vector<Mutant> table = Leaks();
  for (const auto more : {Batches, BadInput, Losses}) {
    for (Mutant& planted : more()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kSceneMutants{MutantKind::kPlanted, 6, SceneMutants};

}  // namespace rasterproof::subjects::mutants
