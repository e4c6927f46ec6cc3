#include "report/view_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace rasterproof::report {
namespace {

constexpr ViewBox kBox{10, 20, 26, 36};

// The clipped segment with its left (then upper) end first.
std::array<Point2, 2> Clipped(Point2 a, Point2 b) {
  const auto clipped = ClipSegment(a, b, kBox);
  EXPECT_TRUE(clipped.has_value());
  if (!clipped) return {};
  auto [p, q] = *clipped;
  if (q.x < p.x || (q.x == p.x && q.y < p.y)) std::swap(p, q);
  return {p, q};
}

void ExpectNear(Point2 p, Point2 q) {
  EXPECT_NEAR(p.x, q.x, 1e-9);
  EXPECT_NEAR(p.y, q.y, 1e-9);
}

TEST(ClipSegmentTest, KeepsASegmentInsideTheBox) {
  const auto [p, q] = Clipped({12, 22}, {20, 30});
  ExpectNear(p, {12, 22});
  ExpectNear(q, {20, 30});
}

TEST(ClipSegmentTest, CutsWhatLeavesTheBox) {
  const auto [p, q] = Clipped({0, 25}, {18, 25});
  ExpectNear(p, {10, 25});
  ExpectNear(q, {18, 25});
}

TEST(ClipSegmentTest, KeepsADiagonalThroughTheCorners) {
  const auto [p, q] = Clipped({0, 10}, {100, 110});
  ExpectNear(p, {10, 20});
  ExpectNear(q, {26, 36});
}

TEST(ClipSegmentTest, GivesNothingForSegmentsBeside) {
  EXPECT_FALSE(ClipSegment({0, 0}, {9, 100}, kBox));
  EXPECT_FALSE(ClipSegment({0, 25}, {9, 25}, kBox));
  EXPECT_FALSE(ClipSegment({15, 25}, {15, 25}, kBox));
}

TEST(ClipSegmentTest, FindsTheLineBetweenEndsThatAreVeryFarAway) {
  // y = x + 3 + 2^-4, between ends of 2^50 that hold its offset exactly.
  const double far = 0x1p+48;
  const auto [p, q] = Clipped({-far, -far + 3.0625}, {3 * far, 3 * far + 3.0});
  // The slope is off by 2^-54: nothing that shows.
  EXPECT_NEAR(p.x, 16.9375 + 0, 0.05);
  EXPECT_NEAR(p.y, 20, 1e-9);
  EXPECT_NEAR(q.y - q.x, 3.0625 - 0.0625 / 4, 0.05);
}

TEST(ClipSegmentTest, IsExactThroughTheOriginAtAnyMagnitude) {
  const ViewBox box{-8, -8, 8, 8};
  for (const double far : {1e3, 1e30, 1e160, 1e300, std::numeric_limits<double>::max()}) {
    const auto clipped = ClipSegment({-far, -far / 2}, {far, far / 2}, box);
    ASSERT_TRUE(clipped) << far;
    for (const Point2 p : *clipped) {
      EXPECT_NEAR(std::fabs(p.x), 8, 1e-9) << far;
      EXPECT_NEAR(p.y, p.x / 2, 1e-9) << far;
    }
  }
}

TEST(ClipSegmentTest, SeesAVerticalEdgeOfAGiantTriangle) {
  const auto [p, q] = Clipped({18.5, -1e30}, {18.5, 1e30});
  ExpectNear(p, {18.5, 20});
  ExpectNear(q, {18.5, 36});
}

TEST(ClipSegmentTest, NeverLeavesTheBoxWhateverTheEnds) {
  constexpr std::array<double, 13> kValues{0,    -0.0, 5e-324, 1e-30, 20.5,  26,    1e7,
                                           1e19, 1e30, -1e30,  -3e38, 1e308, -1e308};
  for (const double ax : kValues) {
    for (const double ay : kValues) {
      for (const double bx : kValues) {
        for (const double by : kValues) {
          const auto clipped = ClipSegment({ax, ay}, {bx, by}, kBox);
          if (!clipped) continue;
          for (const Point2 p : *clipped) {
            EXPECT_TRUE(p.x >= kBox.x0 && p.x <= kBox.x1 && p.y >= kBox.y0 && p.y <= kBox.y1)
                << ax << " " << ay << " " << bx << " " << by;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::report
