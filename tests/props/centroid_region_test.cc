// The stated point of a centroid and the region, by hand-made cases: what lies just within, and
// just beyond.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/vertex.h"
#include "exact/half_planes.h"
#include "props/judging/values/centroid_queries.h"

namespace rasterproof::props {
namespace {

Case FourSamples(Centroid rule, YAxis y_axis) {
  Case c;
  c.scene.width = c.scene.height = 4;
  c.profile.pattern = *StandardPattern(4);
  c.profile.centroid = rule;
  c.profile.y_axis = y_axis;
  return c;
}

// Standard locations of four: (6, 2), (14, 6), (2, 10) and (10, 14) sixteenths.
TEST(StatedCentroid, IsDirect3Ds) {
  const Case c = FourSamples(Centroid::kDirect3D, YAxis::kDown);
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, true, true, true}), (Point2{2.5, 1.5}));
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, true, true, false}), (Point2{2.375, 1.125}));
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {false, true, false, true}),
            (Point2{2.875, 1.375}));
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {false, false, false, true}),
            (Point2{2.625, 1.875}));
}

TEST(StatedCentroid, CountsRowsFromTheTopAndYAsTheProfileDoes) {
  const Case c = FourSamples(Centroid::kDirect3D, YAxis::kUp);
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, true, true, true}), (Point2{2.5, 2.5}));
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, false, false, false}),
            (Point2{2.375, 2.125}));
}

TEST(StatedCentroid, IsNoPointWithin) {
  const Case c = FourSamples(Centroid::kInside, YAxis::kDown);
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, true, true, true}), std::nullopt);
  EXPECT_EQ(StatedCentroid(PlacedCase(c), 2, 1, {true, false, true, true}), std::nullopt);
}

TEST(StatedCentroid, IsTheCentreOfOneSample) {
  for (const Centroid rule : {Centroid::kDirect3D, Centroid::kInside}) {
    Case c = FourSamples(rule, YAxis::kDown);
    for (const Point2 location : {Point2{0.5, 0.5}, Point2{0.25, 0.75}}) {
      c.profile.pattern.locations = {location};
      EXPECT_EQ(StatedCentroid(PlacedCase(c), 3, 0, {true}), (Point2{3.5, 0.5}));
    }
  }
}

// lambda_1 is x / 8, lambda_2 y / 8. The pixel is that of (2, 3): inside the triangle but for its
// corner (3, 4) where the hypotenuse, x + y = 7, cuts it off if `cut`.
CentroidFragment InPixel(bool cut, double x, double y, double tolerance) {
  CentroidFragment f;
  f.query.v = {Point2{0, 0}, Point2{8, 0}, Point2{0, 8}};
  const double side = cut ? 6.5 : 8;
  f.region.low = {2, 3};
  f.region.high = {3, 4};
  f.region.primitive = std::make_shared<const std::vector<exact::HalfPlane>>(
      exact::HullOf({{0, 0}, {side, 0}, {0, side}}));
  f.barycentrics = {1 - x / 8 - y / 8, x / 8, y / 8};
  f.tolerances = {tolerance, tolerance, tolerance};
  return f;
}

constexpr double kTolerance = 0x1p-20;
// A way along x changes two barycentrics by an eighth of it.
constexpr double kWay = 8 * kTolerance;
constexpr double kMore = 1 + 0x1p-20;

bool LiesWithin(const CentroidFragment& f) { return DistanceFromRegion(f).within; }

TEST(CentroidRegion, EndsWithThePixel) {
  EXPECT_TRUE(LiesWithin(InPixel(false, 2.5, 3.5, 0)));
  EXPECT_TRUE(LiesWithin(InPixel(false, 3, 3, 0))) << "the pixel is closed";
  EXPECT_FALSE(LiesWithin(InPixel(false, 3 + kWay, 3.5, 0)));
  for (const int side : {-1, 1}) {
    const double x = side < 0 ? 2 : 3;
    const double y = side < 0 ? 3 : 4;
    EXPECT_TRUE(LiesWithin(InPixel(false, x + side * kWay, 3.5, kTolerance)));
    EXPECT_FALSE(LiesWithin(InPixel(false, x + side * kWay * kMore, 3.5, kTolerance)));
    EXPECT_TRUE(LiesWithin(InPixel(false, 2.5, y + side * kWay, kTolerance)));
    EXPECT_FALSE(LiesWithin(InPixel(false, 2.5, y + side * kWay * kMore, kTolerance)));
  }
}

// Off by kTolerance in x and in y, the third barycentric is off by twice as much: no point explains
// all three, though each pair has one.
TEST(CentroidRegion, IsOfAllBarycentricsAtOnce) {
  EXPECT_FALSE(LiesWithin(InPixel(false, 3 + kWay, 4 + kWay, kTolerance)));
  EXPECT_TRUE(LiesWithin(InPixel(false, 3 + kWay / 2, 4 + kWay / 2, kTolerance)));
  EXPECT_FALSE(LiesWithin(InPixel(false, 3 + kWay / 2 * kMore, 4 + kWay / 2 * kMore, kTolerance)));
  CentroidFragment longer = InPixel(false, 2.5, 3.5, kTolerance);
  for (double& l : longer.barycentrics) l += kTolerance;
  EXPECT_TRUE(LiesWithin(longer)) << "a sum that is off by three tolerances";
  longer.barycentrics[1] += 0x1p-40;
  EXPECT_FALSE(LiesWithin(longer));
}

TEST(CentroidRegion, EndsWithTheTriangle) {
  // The line x + y = 6.5 runs through the pixel.
  EXPECT_TRUE(LiesWithin(InPixel(true, 2.5, 4, 0))) << "the triangle is closed";
  EXPECT_FALSE(LiesWithin(InPixel(true, 2.5 + 0x1p-30, 4, 0)));
  EXPECT_FALSE(LiesWithin(InPixel(true, 2.9, 3.9, kTolerance)));
  // Across it by d in x and y, lambda_0 is off by d / 4.
  EXPECT_TRUE(LiesWithin(InPixel(true, 2.75 + kWay / 2, 3.75 + kWay / 2, kTolerance)));
  EXPECT_FALSE(
      LiesWithin(InPixel(true, 2.75 + kWay / 2 * kMore, 3.75 + kWay / 2 * kMore, kTolerance)));
}

// Beyond both the side x = 3 and the line x + y = 6.5: within each, not within their corner.
TEST(CentroidRegion, IsWhatPixelAndTriangleShare) {
  const Point2 shared{3, 3.5};
  EXPECT_TRUE(LiesWithin(InPixel(true, shared.x, shared.y, 0)));
  EXPECT_TRUE(LiesWithin(InPixel(true, shared.x + kWay, shared.y, kTolerance)));
  EXPECT_FALSE(LiesWithin(InPixel(true, shared.x + kWay, shared.y + kWay / 2, kTolerance)));
}

TEST(CentroidRegion, HasNoPointThatIsNoNumber) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CentroidFragment f = InPixel(false, 2.5, 3.5, kTolerance);
    f.barycentrics[1] = bad;
    EXPECT_FALSE(LiesWithin(f));
    f.region.at = Point2{2.5, 3.5};
    EXPECT_FALSE(LiesWithin(f));
  }
}

TEST(CentroidPoint, IsHeldToItsTolerance) {
  CentroidFragment f = InPixel(false, 2.5, 3.5, kTolerance);
  f.region.at = Point2{2.5, 3.5};
  EXPECT_EQ(DistanceFromRegion(f).ratio, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    CentroidFragment off = f;
    off.barycentrics[i] += kTolerance;
    EXPECT_TRUE(LiesWithin(off));
    EXPECT_EQ(DistanceFromRegion(off).ratio, 1);
    off.barycentrics[i] += 0x1p-40;
    EXPECT_FALSE(LiesWithin(off));
  }
}

}  // namespace
}  // namespace rasterproof::props
