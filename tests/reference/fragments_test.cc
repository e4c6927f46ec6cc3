// The nearest triangle at each pixel, and what is known of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"

namespace rasterproof::reference {
namespace {

constexpr Needs kEverything{true, true, true};
constexpr float kFarDepth = std::numeric_limits<float>::infinity();

FragmentBuffers Shade(const Scene& scene, const Needs& needs = kEverything,
                      const RasterOptions& options = {}) {
  return RasterizeFragments(scene, *FindMethod("spans-exact"), options, needs);
}

Scene TwoOverlappingTriangles(double first_z, double second_z) {
  Scene scene = WindowScene(6, 6, {{0, 0}, {6, 0}, {0, 6}, {0, 0}, {6, 0}, {6, 6}});
  for (std::size_t n = 0; n < 6; ++n) scene.vertices[n].z = n < 3 ? first_z : second_z;
  return scene;
}

TEST(FragmentsTest, TheNearestTriangleWinsAndTheFirstOneWinsTies) {
  EXPECT_EQ(Shade(TwoOverlappingTriangles(1, 2)).triangle[2], 0);
  EXPECT_EQ(Shade(TwoOverlappingTriangles(2, 1)).triangle[2], 1);
  EXPECT_EQ(Shade(TwoOverlappingTriangles(1, 1)).triangle[2], 0);
  EXPECT_EQ(Shade(TwoOverlappingTriangles(1, 2)).triangle[35], -1 + 2);
  EXPECT_EQ(Shade(TwoOverlappingTriangles(2, 1)).depth[2], 1.0F);
}

TEST(FragmentsTest, BuffersThatNobodyAskedForAreEmpty) {
  const Scene scene = TwoOverlappingTriangles(1, 2);
  const FragmentBuffers nothing = Shade(scene, {});
  EXPECT_EQ(nothing.triangle.size(), 36U);
  EXPECT_TRUE(nothing.barycentrics.empty() && nothing.depth.empty() &&
              nothing.edge_distance.empty());
  const FragmentBuffers all = Shade(scene);
  EXPECT_EQ(all.barycentrics.size(), 36U);
  EXPECT_EQ(all.triangle, nothing.triangle);
  EXPECT_EQ(Shade(scene, {false, true, false}).depth, all.depth);
  EXPECT_EQ(Shade(scene, {true, false, false}).barycentrics, all.barycentrics);
  EXPECT_EQ(Shade(scene, {false, false, true}).edge_distance, all.edge_distance);
}

TEST(FragmentsTest, BarycentricsDepthAndDistanceAreThoseOfThePlane) {
  Scene scene = WindowScene(8, 8, {{0, 0}, {8, 0}, {0, 8}});
  scene.vertices[0].z = 1;
  scene.vertices[1].z = 9;
  scene.vertices[2].z = 17;
  const FragmentBuffers out = Shade(scene);
  const std::size_t n = 1 * 8 + 2;  // centre (2.5, 1.5)
  EXPECT_EQ(out.barycentrics[n], (std::array<float, 3>{0.5F, 0.3125F, 0.1875F}));
  EXPECT_EQ(out.depth[n], 1 + 2.5F + 2 * 1.5F);
  EXPECT_EQ(out.edge_distance[n], 1.5F);
  EXPECT_EQ(out.depth[63], kFarDepth);
}

TEST(FragmentsTest, ClipSpaceBarycentricsArePerspectiveCorrectAndAgreeWithWindowSpaceAtWOne) {
  Scene window = WindowScene(8, 8, {{0, 0}, {8, 0}, {0, 8}});
  window.vertices[1].z = 4;
  Scene clip = window;
  clip.clip_space = true;
  const Method& hom = *FindMethod("hom-exact");
  const FragmentBuffers flat = RasterizeFragments(clip, hom, {}, kEverything);
  EXPECT_EQ(flat.triangle, Shade(window).triangle);
  EXPECT_EQ(flat.barycentrics, Shade(window).barycentrics);
  EXPECT_EQ(flat.depth, Shade(window).depth);
  // Halfway along the screen edge from w = 1 to w = 3, the point is a quarter of the way in space.
  for (double* c : {&clip.vertices[1].x, &clip.vertices[1].y, &clip.vertices[1].z}) *c *= 3;
  clip.vertices[1].w = 3;
  const FragmentBuffers deep = RasterizeFragments(clip, hom, {}, kEverything);
  const float near_middle = deep.barycentrics[3][1];  // centre (3.5, 0.5)
  EXPECT_LT(near_middle, 0.25F);
  EXPECT_GT(near_middle, 0.18F);
  EXPECT_EQ(deep.triangle, flat.triangle);
}

TEST(FragmentsTest, ThreadsTilesAndScissorChangeNothingInside) {
  RandomValues random(71);
  std::vector<Point2> points;
  for (int n = 0; n < 60; ++n) points.push_back({random.Uniform(-9, 40), random.Uniform(-9, 40)});
  Scene scene = WindowScene(31, 33, points);
  scene.precision = Precision::kFloat64;
  for (Vertex& v : scene.vertices) v.z = random.Uniform(0, 1);
  const FragmentBuffers expected = Shade(scene);
  RasterOptions options;
  options.threads = 5;
  options.tile = 4;
  options.scissor = PixelRect{3, 4, 29, 30};
  const FragmentBuffers cut = Shade(scene, kEverything, options);
  for (int j = 0; j < 33; ++j) {
    for (int i = 0; i < 31; ++i) {
      const auto n = static_cast<std::size_t>(j * 31 + i);
      const bool in = i >= 3 && i < 29 && j >= 4 && j < 30;
      ASSERT_EQ(cut.triangle[n], in ? expected.triangle[n] : -1);
      ASSERT_EQ(cut.depth[n], in ? expected.depth[n] : kFarDepth);
    }
  }
}

TEST(FragmentsTest, CoverageIsTheMethodsOwn) {
  // Every triangle alone: a pixel has an owner exactly where the method's coverage counts one.
  RandomValues random(72);
  for (const Method& method : Methods()) {
    if (!method.info.takes_window) continue;
    for (int n = 0; n < 20; ++n) {
      const auto c = [&] { return static_cast<float>(random.Uniform(-2, 12)); };
      const Scene scene = WindowScene(9, 9, {{c(), c()}, {c(), c()}, {c(), c()}});
      CoverageCounts counts(9, 9);
      Rasterize(scene, method, {}, counts);
      const FragmentBuffers out = RasterizeFragments(scene, method, {}, {});
      for (std::size_t i = 0; i < counts.size(); ++i) {
        ASSERT_EQ(out.triangle[i], counts.Count(i) > 0 ? 0 : -1) << method.name;
      }
    }
  }
}

TEST(FragmentsTest, ADepthThatIsNoNumberLosesToEveryNumber) {
  Scene scene = TwoOverlappingTriangles(std::nan(""), 5);
  EXPECT_EQ(Shade(scene).triangle[2], 1);
  EXPECT_EQ(Shade(scene).triangle[12], 0);  // covered by the first alone
  EXPECT_EQ(Shade(scene).depth[12], kFarDepth);
}

TEST(FragmentsTest, ScenesThatTheMethodDoesNotTakeAreRefused) {
  Scene clip = TwoOverlappingTriangles(1, 2);
  clip.clip_space = true;
  EXPECT_THROW(Shade(clip), InputError);
}

}  // namespace
}  // namespace rasterproof::reference
