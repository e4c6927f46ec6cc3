#include "exact/homogeneous.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "tests/exact/families.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {
namespace {

NaiveRow RowOf(const Vertex& v) { return {v.x, v.y, v.w}; }

TEST(DeterminantSign, IsThatOfRationalsInEveryFamily) {
  for (int f = 0; f < kFamilies; ++f) {
    const auto family = static_cast<Family>(f);
    Draw draw(41 + static_cast<unsigned>(f));
    for (int k = 0; k < 150; ++k) {
      std::array<Vertex, 3> v;
      for (Vertex& c : v)
        c = {draw.Coordinate(family), draw.Coordinate(family), 0, draw.Coordinate(family)};
      if (k % 5 == 0) v[2] = {v[0].x + v[1].x, v[0].y + v[1].y, 0, v[0].w + v[1].w};
      if (!IsFinite(v[2])) continue;
      const int truth = sgn(NaiveDeterminant(RowOf(v[0]), RowOf(v[1]), RowOf(v[2])));
      for (const Decider decider : kDeciders) {
        ASSERT_EQ(DeterminantSign(v, decider), truth) << FamilyName(family) << " " << k;
        ASSERT_EQ(DeterminantSign({v[1], v[0], v[2]}, decider), -truth);
      }
    }
  }
}

TEST(DeterminantSign, HoldsAtTheEndsOfTheRange) {
  const double max = std::numeric_limits<double>::max();
  const double least = 0x1p-1074;
  for (const Decider decider : kDeciders) {
    EXPECT_EQ(DeterminantSign({{{max, 0, 0, 0}, {0, max, 0, 0}, {0, 0, 0, max}}}, decider), +1);
    EXPECT_EQ(DeterminantSign({{{least, 0, 0, 0}, {0, least, 0, 0}, {0, 0, 0, least}}}, decider),
              +1);
    EXPECT_EQ(
        DeterminantSign({{{max, max, 0, max}, {max, max, 0, least}, {max, -max, 0, 0}}}, decider),
        -1)
        << "worked by hand: -2 max^2 (max - least)";
    EXPECT_EQ(DeterminantSign({{{1, 2, 0, 3}, {4, 5, 0, 6}, {7, 8, 0, 9}}}, decider), 0);
  }
}

TEST(HomogeneousEdgeSign, IsTheProjectedEdgeTimesBothW) {
  Draw draw(43);
  for (int k = 0; k < 2000; ++k) {
    const auto [a, b, p] = draw.EdgeAndPoint(k % 2 == 0 ? Family::kHalfPixels : Family::kUniform);
    const double wa = draw.Sign() * (1 << draw.Below(4));
    const double wb = draw.Sign() * (1 << draw.Below(4));
    const Vertex va{a.x * wa, a.y * wa, 0, wa};
    const Vertex vb{b.x * wb, b.y * wb, 0, wb};
    const int sign = EdgeSign(a, b, p) * (wa * wb > 0 ? 1 : -1);
    for (const Decider decider : kDeciders)
      ASSERT_EQ(HomogeneousEdgeSign(va, vb, p, decider), sign);
    ASSERT_EQ(HomogeneousEdgeValue(va, vb, p), EdgeValue(a, b, p) * wa * wb);
  }
}

TEST(ShiftedHomogeneousEdgeSign, IsTheSignAtTheMovedSampleUnderEveryRule) {
  Draw draw(44);
  int ties = 0;
  for (int k = 0; k < 1500; ++k) {
    const Family family = k % 3 != 0 ? Family::kHalfPixels : static_cast<Family>(k % kFamilies);
    const auto corner = [&] {
      return Vertex{draw.Coordinate(family), draw.Coordinate(family), 0, draw.Coordinate(family)};
    };
    const Vertex vi = corner();
    Vertex vj = corner();
    const Point2 p{draw.Below(8) * 0.5, draw.Below(8) * 0.5};
    if (k % 3 == 1) {  // in the plane of the eye, p and V_i: a tie
      const double m = draw.Below(5) - 2;
      const double n = draw.Below(5) - 2;
      vj = {m * vi.x + n * p.x, m * vi.y + n * p.y, 0, m * vi.w + n};
    }
    const TieRule rule = draw.AnyProfile().tie_rule;
    const NaivePoint moved = NaiveShifted(NaiveAt(p), rule);
    const int truth = sgn(NaiveDeterminant({moved.x, moved.y, 1}, RowOf(vj), RowOf(vi)));
    for (const Decider decider : kDeciders) {
      ASSERT_EQ(ShiftedHomogeneousEdgeSign(vi, vj, p, rule, decider), truth) << TieRuleName(rule);
    }
    if (truth != 0 && HomogeneousEdgeSign(vi, vj, p) == 0) ++ties;
  }
  EXPECT_GT(ties, 200);
}

TEST(HomogeneousCovers, OnlyWhatLiesBeforeTheEye) {
  const std::array<Vertex, 3> before{{{0, 0, 0, 1}, {4, 0, 0, 1}, {0, 4, 0, 1}}};
  std::array<Vertex, 3> behind = before;
  for (Vertex& v : behind) v = {-v.x, -v.y, 0, -v.w};
  EXPECT_TRUE(HomogeneousCovers(before, {1, 1}, kTopLeft));
  EXPECT_FALSE(HomogeneousCovers(behind, {1, 1}, kTopLeft)) << "it projects to the same pixels";
  EXPECT_FALSE(HomogeneousCovers(before, {3, 3}, kTopLeft));
  EXPECT_EQ(HomogeneousFacing(before), -1) << "as in window space";
  // One vertex at infinity to the right: the strip y in [0, 1) of the ray x >= 0.
  const std::array<Vertex, 3> strip{{{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 0}}};
  EXPECT_TRUE(HomogeneousCovers(strip, {1000, 0.5}, kTopLeft));
  EXPECT_FALSE(HomogeneousCovers(strip, {1000, 1.5}, kTopLeft));
  EXPECT_FALSE(HomogeneousCovers(strip, {-1, 0.5}, kTopLeft));
}

// A cube's twelve triangles, wound counter-clockwise as seen from outside, in (x, y, w).
Scene Cube(double half, double shift_w) {
  Scene scene;
  scene.width = scene.height = 32;
  scene.precision = Precision::kFloat64;
  scene.clip_space = true;
  for (int k = 0; k < 8; ++k) {
    const double x = (k & 1) != 0 ? half : -half;
    const double y = (k & 2) != 0 ? half : -half;
    const double w = ((k & 4) != 0 ? half : -half) + shift_w;
    // The viewport's scale: the centre of the target looks along w.
    scene.vertices.push_back({16 * x + 16 * w, 16 * y + 16 * w, 0, w});
  }
  for (const auto& q : std::vector<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    scene.triangles.push_back({q[0], q[1], q[2]});
    scene.triangles.push_back({q[0], q[2], q[3]});
  }
  return scene;
}

TEST(HomogeneousCoverage, OfAClosedSurfaceIsItsWindingAroundTheEye) {
  std::map<std::int64_t, int> signed_counts;
  const CoverageCounts inside = Coverage(Cube(1, 0.25), {});
  for (std::size_t k = 0; k < inside.size(); ++k) ++signed_counts[inside.Signed(k)];
  EXPECT_EQ(signed_counts.size(), 1U) << "the same number all around the eye";
  EXPECT_EQ(std::abs(signed_counts.begin()->first), 1);
  for (const double w : {3.0, 1.0 + 0x1p-40, -1.5}) {
    const CoverageCounts outside = Coverage(Cube(1, w), {});
    for (std::size_t k = 0; k < outside.size(); ++k)
      ASSERT_EQ(outside.Signed(k), 0) << "eye at " << w;
  }
  EXPECT_EQ(inside, Coverage(Cube(1, 0.25), {}, {}, Decider::kIntegers));
}

}  // namespace
}  // namespace rasterproof::exact
