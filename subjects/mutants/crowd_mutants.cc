// Bugs that few triangles do not show: numbers cut to some bits, lanes of a vector, pairs taken for
// what they are not; and those at the ends of what a number holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::size_t kLanes = 8;

// A triangle's vertices are known by scene and number before they are changed: what both stages of
// a mutant share.
struct Known {
  const Scene* scene = nullptr;
  std::size_t number = 0;
};

template <class Change>
FixedStages Changing(const Change& change) {
  const auto known = std::make_shared<Known>();
  return {{.drops =
               [known](const Scene& scene, std::size_t number) {
                 *known = {&scene, number};
                 return false;
               },
           .vertices = [known, change](
                           std::array<Vertex, 3>& v) { change(*known->scene, known->number, v); }}};
}

bool IsInAFullVector(const Scene& scene, std::size_t number) {
  return number / kLanes * kLanes + kLanes <= scene.triangles.size();
}

std::array<Vertex, 3> TriangleOf(const Scene& scene, std::size_t number) {
  return Corners(scene, scene.triangles[number]);
}

double TwiceAreaOf(const std::array<Vertex, 3>& v) {
  return std::fabs((v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x));
}

// Whether the triangle and the one before go together as (a, b, c) and (a, c, d).
bool IsSecondOfAPair(const Scene& scene, std::size_t number) {
  if (number == 0) return false;
  const Triangle& first = scene.triangles[number - 1];
  const Triangle& second = scene.triangles[number];
  return first[0] == second[0] && first[2] == second[1];
}

// Whether the corner b of the triangle is a right angle.
bool IsRightAtB(const std::array<Vertex, 3>& v) {
  return (v[0].x - v[1].x) * (v[2].x - v[1].x) + (v[0].y - v[1].y) * (v[2].y - v[1].y) == 0;
}

// The sound stages, which then change a triangle's edges by the scene that it is of.
FixedStages ChangingEdges(void (*change)(const Scene& scene, GridTriangle& t)) {
  const auto known = std::make_shared<const Scene*>(nullptr);
  return FixedStages{{.drops =
                          [known](const Scene& scene, std::size_t) {
                            *known = &scene;
                            return false;
                          },
                      .edges = [known, change](GridTriangle& t) { change(**known, t); }}};
}

std::vector<Mutant> Cuts() {
  return {
      {"cut-triangle-numbers-12", "numbers of triangles are cut to 12 bits", "",
       Changing([](const Scene& scene, std::size_t number, std::array<Vertex, 3>& v) {
         v = TriangleOf(scene, number & 0xfff);
       }),
       "list"},
      {"cut-vertex-numbers-12", "numbers of vertices are cut to 12 bits", "",
       Changing([](const Scene& scene, std::size_t number, std::array<Vertex, 3>& v) {
         for (std::size_t k = 0; k < 3; ++k) {
           const auto index = static_cast<std::size_t>(scene.triangles[number][k]);
           v[k] = scene.vertices[index & 0xfff];
         }
       }),
       "list"},
      {"cut-cache-tag", "a vertex is taken from the cache where its number agrees in 10 bits", "",
       Changing([](const Scene& scene, std::size_t number, std::array<Vertex, 3>& v) {
         if (number == 0) return;
         for (std::size_t k = 0; k < 3; ++k) {
           const std::int32_t last = scene.triangles[number - 1][k];
           const bool agrees = ((last ^ scene.triangles[number][k]) & 0x3ff) == 0;
           if (agrees) v[k] = scene.vertices[static_cast<std::size_t>(last)];
         }
       }),
       "list"},
      {"lanes-full", "in full vectors of eight triangles the last one's ties are left out", "",
       ChangingEdges([](const Scene& scene, GridTriangle& t) {
         if (t.number % kLanes != kLanes - 1 || !IsInAFullVector(scene, t.number)) return;
         for (GridEdge& e : t.edges) e.owns = false;
       }),
       "list"},
      {"lanes-one-left", "one triangle left of sixteen is drawn without its top edges' samples", "",
       ChangingEdges([](const Scene& scene, GridTriangle& t) {
         const std::size_t all = scene.triangles.size();
         if (all % 16 != 1 || all == 1 || t.number + 1 != all) return;
         for (GridEdge& e : t.edges) {
           if (e.a.y == e.b.y) e.owns = false;
         }
       }),
       "list"},
      {"lanes-partial", "what is left of eight triangles is drawn up to a flat one", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          if (IsInAFullVector(scene, number)) return false;
                          for (std::size_t t = number / kLanes * kLanes; t < number; ++t) {
                            if (TwiceAreaOf(TriangleOf(scene, t)) == 0) return true;
                          }
                          return false;
                        }}},
       "list"},
  };
}

std::vector<Mutant> Pairs() {
  return {
      {"pair-by-one-angle", "two triangles with one right angle are drawn as a rectangle", "",
       Changing([](const Scene& scene, std::size_t number, std::array<Vertex, 3>& v) {
         if (!IsSecondOfAPair(scene, number)) return;
         const std::array<Vertex, 3> first = TriangleOf(scene, number - 1);
         if (!IsRightAtB(first)) return;
         v[2].x = first[0].x + first[2].x - first[1].x;
         v[2].y = first[0].y + first[2].y - first[1].y;
       }),
       "list"},
      {"pair-by-equal-sides", "a kite on a level diagonal is drawn as its box", "",
       Changing([](const Scene& scene, std::size_t number, std::array<Vertex, 3>& v) {
         if (!IsSecondOfAPair(scene, number)) return;
         const std::array<Vertex, 3> first = TriangleOf(scene, number - 1);
         const bool is_kite = first[0].y == first[2].y && first[1].x == v[2].x &&
                              first[1].y + v[2].y == 2 * first[0].y;
         if (is_kite) v[2].x = first[0].x + first[2].x - first[1].x;
       }),
       "list"},
      {"pair-small", "two triangles on an edge whose box is under a pixel are not drawn", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          const auto is_small = [&](std::size_t t) {
                            const std::array<Vertex, 3> v = TriangleOf(scene, t);
                            const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
                            const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
                            return x1 - x0 < 1 && y1 - y0 < 1;
                          };
                          return IsSecondOfAPair(scene, number) && is_small(number - 1) &&
                                 is_small(number);
                        }}},
       "list"},
  };
}

std::vector<Mutant> Ends() {
  return {
      {"overflow-area-multiple", "an area that is a multiple of 2^31 is taken for none", "",
       FixedStages{{.area =
                        [](const std::array<GridPoint, 3>& v) {
                          const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
                          return area % (std::int64_t{1} << 31) == 0 ? 0 : area;
                        }}},
       "overflow"},
      {"overflow-saturates-24", "an edge value of 2^24 to 2^24 + 2^13 counts as none", "",
       FixedStages{{.value =
                        [](const GridEdge& e, const Sample& at) {
                          const std::int64_t value = e.At(at.at);
                          const std::int64_t beyond = value - (std::int64_t{1} << 24);
                          return beyond >= 0 && beyond < 8192 ? -1 : value;
                        }}}},
      {"depth-not-finite",
       "a triangle with a z that is not finite is dropped, though z plays no part", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return std::ranges::any_of(
                              TriangleOf(scene, number),
                              [](const Vertex& p) { return !std::isfinite(p.z); });
                        }}},
       "not-finite"},
      {"clip-one-behind", "one vertex behind the eye is projected like the others", "",
       ClipStages{{.clip =
                       [](const ClipTriangle& v) {
                         ClipTriangle projected = v;
                         const auto is_behind = [](const Vertex& p) { return p.w < 0; };
                         if (std::ranges::count_if(v, is_behind) == 1) {
                           for (Vertex& p : projected) {
                             if (is_behind(p)) p = {-p.x, -p.y, -p.z, -p.w};
                           }
                         }
                         return std::vector<ClipTriangle>{projected};
                       }}},
       "clip-space"},
  };
}

std::vector<Mutant> CrowdMutants() {
  std::vector<Mutant> table = Cuts();
  for (Mutant& planted : Pairs()) table.push_back(std::move(planted));
  for (Mutant& planted : Ends()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kCrowdMutants{MutantKind::kPlanted, 7, CrowdMutants};

}  // namespace rasterproof::subjects::mutants
