#include "exact/attributes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/ulp.h"
#include "tests/exact/families.h"

namespace rasterproof::exact {
namespace {

constexpr std::array<Point2, 3> kTriangle{{{0, 0}, {4, 0}, {0, 4}}};

TEST(Barycentrics, AreOneAtTheirVertexAndSignedOutside) {
  for (unsigned k = 0; k < 3; ++k) {
    const auto at_vertex = Barycentrics(kTriangle, kTriangle[k]);
    for (unsigned i = 0; i < 3; ++i) EXPECT_EQ((*at_vertex)[i], Rational(i == k ? 1 : 0));
  }
  const auto outside = Barycentrics(kTriangle, {2, -1});
  EXPECT_EQ((*outside)[0].ToString(), "3/4");
  EXPECT_EQ((*outside)[1].ToString(), "1/2");
  EXPECT_EQ((*outside)[2].ToString(), "-1/4");
}

TEST(Barycentrics, SumToOneAndReproduceThePointExactly) {
  Draw draw(21);
  int seen = 0;
  for (int k = 0; k < 260; ++k) {
    const Family family = static_cast<Family>(k % kFamilies);
    const std::array<Point2, 3> v = draw.EdgeAndPoint(family);
    const Point2 p = draw.EdgeAndPoint(family)[0];
    const auto lambda = Barycentrics(v, p);
    if (!lambda) continue;
    ++seen;
    ASSERT_EQ((*lambda)[0] + (*lambda)[1] + (*lambda)[2], Rational(1));
    ASSERT_EQ(*Interpolate(v, {v[0].x, v[1].x, v[2].x}, p), Rational(p.x));
    ASSERT_EQ(*Interpolate(v, {v[0].y, v[1].y, v[2].y}, p), Rational(p.y));
  }
  EXPECT_GT(seen, 150);
}

TEST(Barycentrics, AreNothingWithoutArea) {
  EXPECT_FALSE(Barycentrics({{{0, 0}, {1, 1}, {3, 3}}}, {0, 1}));
  EXPECT_FALSE(Interpolate({{{0, 0}, {1, 1}, {3, 3}}}, {1, 2, 3}, {0, 1}));
}

TEST(InterpolatePerspective, MeetsTheEyeSpaceMidpointWhereTheScreenDoes) {
  // Depths 1 and 4 at the ends of an edge: half way on screen the ray is at depth 2 / (1 + 1/4).
  const auto depth = InterpolatePerspective(kTriangle, {1, 4, 1}, {1, 4, 1}, {2, 0});
  EXPECT_EQ(depth->ToString(), "8/5");
  EXPECT_EQ(InterpolatePerspective(kTriangle, {3, 3, 3}, {1, 4, 1}, {2, 0})->ToString(), "5/2");
  EXPECT_FALSE(InterpolatePerspective(kTriangle, {1, 0, 1}, {1, 4, 1}, {2, 0}));
  EXPECT_FALSE(InterpolatePerspective(kTriangle, {1, -1, 1}, {1, 4, 1}, {2, 0}))
      << "the denominator is zero";
}

TEST(SquaredLineDistance, IsThatOfTheLineNotOfTheSegment) {
  EXPECT_EQ(SquaredLineDistance({0, 0}, {3, 4}, {5, 0})->ToString(), "16");
  EXPECT_EQ(SquaredLineDistance({0, 0}, {1, 0}, {100, -3})->ToString(), "9");
  EXPECT_EQ(SquaredLineDistance({0, 0}, {1, 1}, {1, 0})->ToString(), "1/2");
  EXPECT_FALSE(SquaredLineDistance({2, 2}, {2, 2}, {1, 0}));
}

TEST(NearestSquareRoot, RoundsAsTheProcessorDoes) {
  Draw draw(22);
  for (int k = 0; k < 300; ++k) {
    const double x = std::fabs(draw.Coordinate(static_cast<Family>(k % kFamilies)));
    ASSERT_EQ(NearestSquareRoot(Rational(x)), std::sqrt(x));
  }
}

TEST(NearestSquareRoot, HoldsAtTheEndsOfTheRange) {
  const double max = std::numeric_limits<double>::max();
  const Rational least(0x1p-1074);
  EXPECT_EQ(NearestSquareRoot(Rational(max) * max), max);
  EXPECT_EQ(NearestSquareRoot(least * least), 0x1p-1074);
  EXPECT_EQ(NearestSquareRoot(least * least / 4), 0) << "half the least: a tie, to even";
  EXPECT_EQ(NearestSquareRoot(least * least * 9 / 4), 0x1p-1073) << "three halves: a tie, to even";
  const Rational beyond = Rational(max) + 0x1p970;
  EXPECT_EQ(NearestSquareRoot(beyond * beyond), std::numeric_limits<double>::infinity());
  EXPECT_EQ(NearestSquareRoot(beyond * beyond - 1), max);
  EXPECT_EQ(NearestSquareRoot(Rational(0)), 0);
}

}  // namespace
}  // namespace rasterproof::exact
