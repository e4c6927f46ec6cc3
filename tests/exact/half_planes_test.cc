// Rectangles and half planes: hand-made contacts, and the corners of the common part tried one by
// one.
#include "exact/half_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "exact/rational.h"

namespace rasterproof::exact {
namespace {

constexpr Point2 kLow{2, 3};
constexpr Point2 kHigh{3, 4};

bool Holds(const HalfPlane& plane, const Rational& x, const Rational& y) {
  return (plane.a * x + plane.b * y + plane.c).Sign() >= 0;
}

bool HoldAll(const std::vector<HalfPlane>& planes, const Rational& x, const Rational& y) {
  return std::ranges::all_of(planes, [&](const HalfPlane& plane) { return Holds(plane, x, y); });
}

TEST(HalfPlanes, ARectangleMeetsWhatTouchesIt) {
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {}));
  // x + y >= 7 has the corner (3, 4) alone.
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {{1, 1, -7}}));
  EXPECT_FALSE(RectangleMeets(kLow, kHigh, {{1, 1, Rational(-7) - Rational(0x1p-1000)}}));
  // x <= 2 has the left side alone, and of that y >= 4 a corner.
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {{-1, 0, 2}, {0, 1, -4}}));
  EXPECT_FALSE(
      RectangleMeets(kLow, kHigh, {{-1, 0, 2}, {0, 1, Rational(-4) - Rational(0x1p-1000)}}));
}

TEST(HalfPlanes, ThreeMayShareAPointOrPassEachOther) {
  // x >= 5/2, y >= 7/2, x + y <= 6: one point; a hair less and every two of them still meet.
  const HalfPlane right{2, 0, -5};
  const HalfPlane below{0, 2, -7};
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {right, below, {-1, -1, 6}}));
  const HalfPlane less{-1, -1, Rational(6) - Rational(0x1p-1000)};
  EXPECT_FALSE(RectangleMeets(kLow, kHigh, {right, below, less}));
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {right, less}));
  EXPECT_TRUE(RectangleMeets(kLow, kHigh, {below, less}));
}

TEST(HalfPlanes, ARectangleMayBeAPoint) {
  EXPECT_TRUE(RectangleMeets(kLow, kLow, {{1, 1, -5}, {-1, -1, 5}}));
  EXPECT_FALSE(RectangleMeets(kLow, kLow, {{1, 1, -6}}));
}

TEST(HalfPlanes, AHullIsOfItsOutermostPoints) {
  // A square with a point inside, one on a side, and a corner twice.
  const std::vector<HalfPlane> square =
      HullOf({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {2, 0}, {4, 4}});
  EXPECT_EQ(square.size(), 4U);
  for (const auto& [x, y, inside] : {std::array<double, 3>{0, 0, 1},
                                     {4, 4, 1},
                                     {2, 4, 1},
                                     {3, 1, 1},
                                     {-0x1p-30, 2, 0},
                                     {2, 4 + 0x1p-30, 0}}) {
    EXPECT_EQ(HoldAll(square, x, y), inside == 1) << x << ", " << y;
  }
  EXPECT_EQ(HullOf({{0, 0}, {1, 0}, {0, 1}}).size(), 3U);
  EXPECT_EQ(HullOf({{0, 0}, {0, 1}, {1, 0}}).size(), 3U) << "either way round";
}

TEST(HalfPlanes, BarycentricsHaveBoundsOnBothSides) {
  for (const std::array<Point2, 3>& v : {std::array<Point2, 3>{Point2{0, 0}, {0, 8}, {8, 0}},
                                         std::array<Point2, 3>{Point2{0, 0}, {8, 0}, {0, 8}}}) {
    // At (2, 4) or (4, 2), a quarter of v[0], and of the others a half and a quarter.
    const std::array<Rational, 3> at{0.25, 0.5, 0.25};
    const Point2 p{(v[1].x + v[1].x + v[2].x) / 4, (v[1].y + v[1].y + v[2].y) / 4};
    EXPECT_TRUE(RectangleMeets(p, p, WhereBarycentricsAre(v, at, at)));
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double off : {0x1p-60, -0x1p-60}) {
        std::array<Rational, 3> moved = at;
        moved[i] += off;
        EXPECT_FALSE(RectangleMeets(p, p, WhereBarycentricsAre(v, moved, moved)));
        EXPECT_EQ(RectangleMeets(p, p, WhereBarycentricsAre(v, at, moved)), off > 0);
        EXPECT_EQ(RectangleMeets(p, p, WhereBarycentricsAre(v, moved, at)), off < 0);
      }
    }
  }
}

// A second opinion: what is closed, convex and bounded has a corner, where two of its lines cross.
bool HasACorner(Point2 low, Point2 high, std::vector<HalfPlane> planes) {
  planes.push_back({1, 0, -low.x});
  planes.push_back({-1, 0, high.x});
  planes.push_back({0, 1, -low.y});
  planes.push_back({0, -1, high.y});
  for (const HalfPlane& p : planes) {
    for (const HalfPlane& q : planes) {
      const Rational determinant = p.a * q.b - q.a * p.b;
      if (determinant.Sign() == 0) continue;
      const Rational x = (p.b * q.c - q.b * p.c) / determinant;
      const Rational y = (q.a * p.c - p.a * q.c) / determinant;
      if (HoldAll(planes, x, y)) return true;
    }
  }
  return false;
}

TEST(HalfPlanes, ClippingFindsWhatTheCornersFind) {
  std::mt19937_64 bits(107);
  const auto draw = [&](int most) {
    return static_cast<double>(static_cast<int>(bits() % (2 * static_cast<unsigned>(most) + 1)) -
                               most);
  };
  int met = 0;
  constexpr int kCases = 4000;
  for (int n = 0; n < kCases; ++n) {
    std::vector<HalfPlane> planes;
    const auto count = 1 + bits() % 6;
    // Small numbers, so that lines often meet in one point; through the rectangle or beside it.
    for (std::size_t k = 0; k < count; ++k) {
      const double a = draw(2);
      const double b = draw(2);
      planes.push_back({a, b, Rational(-2.5 * a - 3.5 * b) + Rational(draw(3)) / Rational(4)});
    }
    const bool meets = RectangleMeets(kLow, kHigh, planes);
    EXPECT_EQ(meets, HasACorner(kLow, kHigh, planes)) << n;
    met += meets ? 1 : 0;
  }
  EXPECT_GT(met, kCases / 10);
  EXPECT_LT(met, kCases * 9 / 10);
}

}  // namespace
}  // namespace rasterproof::exact
