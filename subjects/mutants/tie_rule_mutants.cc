// Bugs in who owns a sample on an edge, and in which way a triangle faces.
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

bool IsHorizontal(const GridEdge& e) { return e.a.y == e.b.y; }
bool IsVertical(const GridEdge& e) { return e.a.x == e.b.x; }
// Owned by the opposite rule: with every sign turned over.
bool Other(const GridEdge& e) { return !e.owns; }

// Changes who owns each edge, whatever the sample.
FixedStages Owning(bool (*owns)(const GridEdge&)) {
  return {
      {.owns = [owns](const GridEdge& e, const GridTriangle&, const Sample&) { return owns(e); }}};
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> Ties() {
  return {
      {"ties-inclusive", "every edge owns its samples",
       "WebGL #1797, where the reference renderer did; Avocado #18",
       Owning([](const GridEdge&) { return true; }), "tie-rule",
       "ClosedMeshCancels|CoverageEqualsTheModel|EmbeddedMeshSamplesAreCoveredOnce|"
       "SharedEdgeSamplesAreCoveredOnce|SignedCoverageEqualsTheWindingNumber"},
      {"ties-exclusive", "no edge owns its samples", "",
       Owning([](const GridEdge&) { return false; }), "tie-rule"},
      {"ties-horizontal-inclusive", "every horizontal edge owns its samples",
       "SerenityOS #13835; passes the published conformance checks",
       Owning([](const GridEdge& e) { return e.owns || IsHorizontal(e); }), "tie-rule"},
      {"ties-horizontal-exclusive", "no horizontal edge owns its samples", "SerenityOS #13738",
       Owning([](const GridEdge& e) { return e.owns && !IsHorizontal(e); }), "tie-rule"},
      {"ties-vertical-exclusive", "no vertical edge owns its samples", "",
       Owning([](const GridEdge& e) { return e.owns && !IsVertical(e); }), "tie-rule"},
      {"ties-bottom-left", "bottom edges own their samples, and top ones don't", "",
       Owning([](const GridEdge& e) { return IsHorizontal(e) ? !e.owns : e.owns; }), "tie-rule"},
      {"ties-right", "right edges own their samples, and left ones don't", "",
       Owning([](const GridEdge& e) { return IsHorizontal(e) ? e.owns : !e.owns; }), "tie-rule"},
      {"ties-by-slope", "an edge that falls to the right owns its samples", "",
       Owning([](const GridEdge& e) { return e.owns != (e.b.x > e.a.x && e.b.y > e.a.y); }),
       "tie-rule"},
      {"ties-per-tile", "odd tiles use the opposite rule",
       "legal in Vulkan, illegal in OpenGL and under a sample-exact profile",
       FixedStages{{.owns =
                        [](const GridEdge& e, const GridTriangle&, const Sample& at) {
                          return (at.x / 8 + at.row / 8) % 2 == 0 ? e.owns : Other(e);
                        }}},
       "tie-rule"},
      {"ties-by-facing", "back faces use the opposite rule", "",
       FixedStages{{.owns = [](const GridEdge& e, const GridTriangle& t,
                               const Sample&) { return t.front ? e.owns : Other(e); }}},
       "tie-rule"},
      {"ties-first-edge", "the rule is left out for the edge opposite the first vertex", "",
       FixedStages{{.edges = [](GridTriangle& t) { t.edges[0].owns = true; }}}, "tie-rule",
       "VertexRotationKeepsCoverage"},
      {"ties-before-snap", "which edges are left or top ones is decided before the snap", "",
       [] {
         const auto drawn = std::make_shared<const Scene*>(nullptr);
         return FixedStages{{.drops =
                                 [drawn](const Scene& scene, std::size_t) {
                                   *drawn = &scene;
                                   return false;
                                 },
                             .edges =
                                 [drawn](GridTriangle& t) {
                                   for (std::size_t i = 0; i < 3; ++i) {
                                     const auto at = [&](std::size_t k) {
                                       const std::int32_t index = t.indices[k % 3];
                                       return (*drawn)->vertices[static_cast<std::size_t>(index)];
                                     };
                                     const double dx = at(i + 2).x - at(i + 1).x;
                                     const double dy = at(i + 2).y - at(i + 1).y;
                                     t.edges[i].owns = dy > 0 || (dy == 0 && dx < 0);
                                   }
                                 }}};
       }(),
       "tie-rule"},
      {"ties-by-index", "an edge is owned by the triangle that walks it towards the larger index",
       "a shared edge with duplicated vertices has four indices",
       FixedStages{{.edges =
                        [](GridTriangle& t) {
                          for (std::size_t i = 0; i < 3; ++i) {
                            t.edges[i].owns = t.indices[(i + 1) % 3] < t.indices[(i + 2) % 3];
                          }
                        }}},
       "tie-rule"},
      {"ties-in-a-band", "edge values within 1/256 of a square pixel count as on the edge", "",
       FixedStages{
           {.value = [](const GridEdge& e, const Sample& at) { return e.At(at.at) / 256 * 256; }}},
       "edge-precision"},
      {"ties-flipped-late", "y up is drawn y down, and the image is turned over afterwards",
       "what H - y does to a rule that is not symmetric",
       [] {
         FixedStages stages =
             Owning([](const GridEdge& e) { return IsHorizontal(e) ? !e.owns : e.owns; });
         stages.profile.y_axis = YAxis::kUp;
         return stages;
       }(),
       "tie-rule"},
  };
}

std::vector<Mutant> Facings() {
  return {
      {"facing-exchanged", "front and back are exchanged", "",
       FixedStages{{.facing = [](GridTriangle& t) { t.front = !t.front; }}},
       "facing|facing-arithmetic"},
      {"facing-back-lost", "back faces are never drawn", "",
       FixedStages{{.area =
                        [](const std::array<GridPoint, 3>& v) {
                          const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
                          return area > 0 ? area : 0;
                        }}},
       "facing|facing-arithmetic", "ReversalSwapsFacing"},
      {"flat-of-input", "a triangle without area before the snap is left out",
       "D3D11.3 decides it after it",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          const std::array<Vertex, 3> v = Corners(scene, scene.triangles[number]);
                          const double area = (v[2].x - v[0].x) * (v[1].y - v[0].y) -
                                              (v[2].y - v[0].y) * (v[1].x - v[0].x);
                          return area < 0x1p-9 && area > -0x1p-9;
                        }}},
       "", "CoverageEqualsTheModel"},
      {"facing-in-float", "the area is computed in float32 from a constant term", "",
       FixedStages{{.area =
                        [](const std::array<GridPoint, 3>& v) {
                          const auto cross = [](const GridPoint& a, const GridPoint& b) {
                            return static_cast<float>(a.y) * static_cast<float>(b.x) -
                                   static_cast<float>(a.x) * static_cast<float>(b.y);
                          };
                          const float area =
                              cross(v[0], v[1]) + cross(v[1], v[2]) + cross(v[2], v[0]);
                          return std::int64_t{(area > 0) - (area < 0)};
                        }}},
       "facing|facing-arithmetic"},
  };
}

std::vector<Mutant> TieRuleMutants() {
  std::vector<Mutant> table = Ties();
  for (Mutant& planted : Facings()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kTieRuleMutants{MutantKind::kPlanted, 1, TieRuleMutants};

}  // namespace rasterproof::subjects::mutants
