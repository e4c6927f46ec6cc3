// What scenes/README.md says of the bundled scenes, checked in exact integers.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/profile.h"
#include "exact/coverage.h"
#include "gtest/gtest.h"
#include "io/mesh.h"
#include "io/scene_file.h"
#include "io/scene_set.h"

namespace rasterproof::io {
namespace {

// Coordinates of the plane scenes are multiples of 2^-21 below 2^11: integers below 2^32 here,
// whose products fit 128 bits.
__extension__ using Int128 = __int128;

Int128 OnGrid(double x) {
  const double scaled = std::ldexp(x, 21);
  EXPECT_EQ(scaled, std::floor(scaled));
  EXPECT_LT(std::fabs(scaled), 0x1p32);
  return static_cast<std::int64_t>(scaled);
}

// Twice the area, positive if the triangle turns clockwise on screen.
Int128 TwiceArea(const Scene& scene, const Triangle& t) {
  const auto [a, b, c] = Corners(scene, t);
  const Int128 ax = OnGrid(a.x);
  const Int128 ay = OnGrid(a.y);
  return (OnGrid(b.x) - ax) * (OnGrid(c.y) - ay) - (OnGrid(b.y) - ay) * (OnGrid(c.x) - ax);
}

// How many of the places lie on the edge from a to b, and not at its ends. Differences of the map's
// coordinates are multiples of 2^-11 below 2^11: their products are exact in double.
std::size_t Inside(const Scene& scene, std::int32_t a, std::int32_t b,
                   const std::set<std::pair<double, double>>& places) {
  const Vertex& p = scene.vertices[static_cast<std::size_t>(a)];
  const Vertex& q = scene.vertices[static_cast<std::size_t>(b)];
  const auto is_inside = [&](const std::pair<double, double>& v) {
    const double px = v.first - p.x;
    const double py = v.second - p.y;
    const double qx = q.x - v.first;
    const double qy = q.y - v.second;
    const bool is_end = (px == 0 && py == 0) || (qx == 0 && qy == 0);
    return !is_end && px * qx >= 0 && py * qy >= 0 && px * qy == py * qx;
  };
  return static_cast<std::size_t>(std::ranges::count_if(places, is_inside));
}

TEST(BundledScenesTest, EveryEntryOfTheSetIsThere) {
  for (const SceneEntry& entry : ReadSceneSet("scenes/certify.json")) {
    if (!entry.path.ends_with(".json")) continue;
    const Scene scene = ReadScene(entry.path);
    EXPECT_EQ(scene.name, entry.name);
    EXPECT_FALSE(scene.triangles.empty()) << entry.name;
  }
}

TEST(BundledScenesTest, TheMapAndTheGlyphsArePlanarSubdivisions) {
  for (const auto& [path, triangles, shared] : {std::tuple{"scenes/map.json", 9102U, 11395U},
                                                std::tuple{"scenes/glyphs.json", 3399U, 3373U}}) {
    const Scene scene = ReadScene(path);
    EXPECT_EQ(scene.triangles.size(), triangles) << path;
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (const Triangle& t : scene.triangles) {
      ASSERT_GT(TwiceArea(scene, t), 0) << path;
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << path << ": directed edge twice";
      }
    }
    std::size_t inner = 0;
    for (const auto& [a, b] : edges) inner += edges.contains({b, a}) ? 1U : 0U;
    EXPECT_EQ(inner / 2, shared) << path;
  }
}

TEST(BundledScenesTest, TheEarcutMapFillsItsFrameWithTJunctionsAndVerticesOfEqualValue) {
  const Scene scene = ReadScene("scenes/map-earcut.json");
  EXPECT_EQ(scene.triangles.size(), 3360U);
  EXPECT_EQ(scene.vertices.size(), 3460U);
  std::set<std::pair<double, double>> places;
  for (const Vertex& v : scene.vertices) places.emplace(v.x, v.y);
  EXPECT_EQ(places.size(), 2042U);
  Int128 area = 0;
  std::size_t inside_edges = 0;
  for (const Triangle& t : scene.triangles) {
    ASSERT_GT(TwiceArea(scene, t), 0);
    area += TwiceArea(scene, t);
    for (std::size_t k = 0; k < 3; ++k) inside_edges += Inside(scene, t[k], t[(k + 1) % 3], places);
  }
  EXPECT_TRUE(area == (Int128{2} * 977 * 191 << 42));
  EXPECT_EQ(inside_edges, 718U);
  const CoverageCounts counts = exact::Coverage(scene, Profile{});
  for (std::size_t k = 0; k < counts.size(); ++k) ASSERT_EQ(counts.Count(k), 1U) << k;
}

TEST(BundledScenesTest, TheBunnyIsClosed) {
  const std::string path = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "glmark2-data is not installed";
  const Mesh mesh = ReadMesh(path);
  EXPECT_EQ(mesh.vertices.size(), 34835U);
  EXPECT_EQ(mesh.triangles.size(), 69666U);
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "directed edge twice";
    }
  }
  for (const auto& [a, b] : edges) ASSERT_TRUE(edges.contains({b, a})) << "open edge";
}

}  // namespace
}  // namespace rasterproof::io
