#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/palette.h"
#include "report/picture.h"

namespace rasterproof::report {
namespace {

// Four pixels in a row: nothing, then the triangles 0, 0 and 1.
FragmentBuffers FourPixels() {
  FragmentBuffers fragments;
  fragments.width = 4;
  fragments.height = 1;
  fragments.triangle = {-1, 0, 0, 1};
  return fragments;
}

TEST(PaintFlatTest, GivesEachTriangleAColourOfItsOwn) {
  io::Image image = PaintFlat(FourPixels());
  EXPECT_EQ(image.At(1, 0), image.At(2, 0));
  EXPECT_NE(image.At(1, 0), image.At(3, 0));
  EXPECT_NE(image.At(0, 0), image.At(1, 0));
}

TEST(PaintBarycentricsTest, ShowsTheVertexColoursAtTheVertices) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  FragmentBuffers fragments = FourPixels();
  fragments.barycentrics = {{9, 9, 9}, {1, 0, 0}, {-5, 0, 7}, {kNan, 0, 0}};
  io::Image image = PaintBarycentrics(fragments);
  EXPECT_EQ(image.At(1, 0), kVermilion);
  EXPECT_EQ(image.At(2, 0), kBlue);
  EXPECT_EQ(image.At(3, 0)[0], image.At(3, 0)[2]);
}

TEST(PaintDepthTest, IsLightNearAndDarkFar) {
  FragmentBuffers fragments = FourPixels();
  fragments.depth = {std::numeric_limits<float>::infinity(), -2, 0, 3};
  io::Image image = PaintDepth(fragments);
  const auto light = [&](int x) {
    return image.At(x, 0)[0] + image.At(x, 0)[1] + image.At(x, 0)[2];
  };
  EXPECT_GT(light(1), light(2));
  EXPECT_GT(light(2), light(3));
}

TEST(PaintDepthTest, TakesOneDepthAndNone) {
  FragmentBuffers fragments = FourPixels();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  fragments.depth = {kNan, 1, 1, 1};
  EXPECT_EQ(PaintDepth(fragments).pixels.size(), 4U);
  fragments.depth = {kNan, kNan, kNan, kNan};
  EXPECT_EQ(PaintDepth(fragments).pixels.size(), 4U);
}

TEST(PaintWireframeTest, DrawsALineOfTheGivenWidth) {
  FragmentBuffers fragments = FourPixels();
  fragments.edge_distance = {0, 0.25F, 1.0F, 9.0F};
  io::Image thin = PaintWireframe(fragments, 1);
  EXPECT_NE(thin.At(1, 0), thin.At(3, 0));
  EXPECT_EQ(thin.At(2, 0), thin.At(3, 0));
  io::Image thick = PaintWireframe(fragments, 4);
  EXPECT_EQ(thick.At(2, 0), kInk);
}

TEST(PaintCountsTest, GrowsWithTheCount) {
  CoverageCounts counts(6, 1);
  counts.front = {0, 1, 1, 3, 4, 0xFFFFFFFF};
  counts.back = {0, 0, 1, 0, 0, 0xFFFFFFFF};
  io::Image image = PaintCounts(counts);
  EXPECT_EQ(image.At(0, 0), kPaper);
  EXPECT_EQ(image.At(1, 0)[0], 200);
  for (int x = 0; x < 4; ++x) EXPECT_NE(image.At(x, 0), image.At(x + 1, 0));
  EXPECT_EQ(image.At(4, 0), image.At(5, 0));
}

TEST(PaintDifferenceTest, TellsMissingUnexpectedAndFacingApart) {
  CoverageCounts expected(4, 1);
  expected.front = {1, 1, 1, 1};
  CoverageCounts observed = expected;
  observed.front = {0, 2, 0, 1};
  observed.back = {0, 0, 1, 0};
  io::Image image = PaintDifference(observed, expected);
  EXPECT_EQ(image.At(0, 0), kVermilion);
  EXPECT_EQ(image.At(1, 0), kBlue);
  EXPECT_EQ(image.At(2, 0), kPurple);
  EXPECT_NE(image.At(3, 0), kVermilion);
}

TEST(EnlargedTest, CutsThePartOutAndDrawsEdges) {
  io::Image image(4, 3, {1, 2, 3});
  image.At(2, 1) = {9, 9, 9};
  Scene scene;
  scene.width = 4;
  scene.height = 3;
  scene.vertices = {{-9, 1.5, 0, 1}, {9, 1.5, 0, 1}, {0, 90, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  io::Image part = Enlarged(image, scene, {1, 1, 3, 2}, 3, YAxis::kDown);
  EXPECT_EQ(part.width, 6);
  EXPECT_EQ(part.height, 3);
  EXPECT_EQ(part.At(2, 2), (Colour{1, 2, 3}));
  EXPECT_EQ(part.At(3, 0), (Colour{9, 9, 9}));
  io::Image drawn = Enlarged(image, scene, {0, 0, 4, 3}, 5, YAxis::kDown);
  EXPECT_EQ(drawn.At(1, 7), kInk);
  EXPECT_EQ(drawn.At(1, 4), (Colour{1, 2, 3}));
  scene.vertices[0].y = scene.vertices[1].y = 0.5;
  EXPECT_EQ(Enlarged(image, scene, {0, 0, 4, 3}, 5, YAxis::kUp).At(1, 12), kInk);
}

}  // namespace
}  // namespace rasterproof::report
