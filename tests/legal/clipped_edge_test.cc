// The joint verdict where clipping may move an edge that leaves the target.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "legal/clipped_triangle.h"
#include "legal/joint.h"

namespace rasterproof::legal {
namespace {

// Two triangles on either side of an edge from (0, 4) that leaves the target for (64, 8).
Scene LeavingNeighbours() {
  Scene scene;
  scene.width = 8;
  scene.height = 8;
  scene.vertices = {{0, 4}, {64, 8}, {0, 8}, {64, 0}};
  scene.triangles = {{0, 1, 2}, {0, 3, 1}};
  return scene;
}

// `below`, and `above`: how often each sample is covered under y = 4 + x / 16, and over it, but for
// the sample (column, 4), which `there` triangles cover.
Legality LegalityOfLeaving(const Profile& profile, int column, std::uint32_t there) {
  CoverageCounts counts(8, 8, 1);
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < 8; ++x) {
      const double at = row + 0.5;
      const bool lower = at > 4 + (x + 0.5) / 16;
      const bool upper = !lower && at > 4 - (x + 0.5) / 16;
      counts.front[counts.Index(x, row, 0)] = lower || upper ? 1 : 0;
    }
  }
  counts.front[counts.Index(column, 4, 0)] = there;
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(LeavingNeighbours(), {profile, LeavingNeighbours()}, observed).legality;
}

TEST(JudgeJointly, LetsClippingMoveAnEdgeThatLeavesByLessThanAStep) {
  Profile set = *PresetProfile("vulkan");
  // (7.5, 4.5) is 1/32 of a pixel below the edge, half a step of the coarsest grid.
  for (const std::uint32_t there : {0U, 1U, 2U}) {
    EXPECT_EQ(LegalityOfLeaving(set, 7, there), Legality::kLegal) << there;
  }
  // (3.5, 4.5) is more than four steps off: a gap there, or an overlap, is none of clipping's.
  EXPECT_EQ(LegalityOfLeaving(set, 3, 1), Legality::kLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 2), Legality::kNotLegal);
  // (6.5, 4.5) is 3/32 off: a step and a half.
  EXPECT_EQ(LegalityOfLeaving(set, 6, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 6, 2), Legality::kNotLegal);
}

// The edge from (0, 4) to (64, 8), moved by less than 1/16 on each axis, sweeps
// |E| <= (64 + 4) / 16 = 4.25: up to y = 4 + 7.75 / 64 at x = 3, and not 2^-47 beyond.
TEST(ClippedTriangle, AnEdgeReachesAsFarAsItsPlacesAndNoFurther) {
  const ClippedTriangle triangle({Point2{0, 4}, {64, 8}, {0, 8}}, {false, true, false},
                                 WindowBox{0, 0, 8, 8}, Snap{.bits = 4});
  constexpr double kEnd = 4 + 7.75 / 64;
  EXPECT_FALSE(triangle.Keeps(0, {3, kEnd}));
  EXPECT_TRUE(triangle.Keeps(0, {3, kEnd - 0x1p-47}));
}

// In rationals: the moved edge stays between the ends of the stretch, which give it no more room
// than 2^-47 of its largest coordinate beyond.
TEST(ClippedTriangle, ItsStretchHoldsEveryMovedEdgeAndLittleMore) {
  using exact::Rational;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> inside(0, 8);
  std::uniform_real_distribution<double> far(-32768, 32768);
  int tried = 0;
  for (int k = 0; k < 20000; ++k) {
    Point2 a{inside(random), inside(random)};
    Point2 b{far(random), far(random) / (1 << k % 16)};
    if (k % 2) std::swap(b.x, b.y);
    const ClippedTriangle triangle({a, b, {4, 4}}, {false, true, false}, WindowBox{0, 0, 8, 8},
                                   Snap{.bits = 4});
    const auto stretch = triangle.StraightStretchOf(0);
    if (!stretch) continue;
    ++tried;
    const double room = 0x1p-47 * std::max({std::fabs(b.x), std::fabs(b.y), 8.0});
    const auto turned = [&](Point2 p) { return stretch->along_y ? Point2{p.y, p.x} : p; };
    a = turned(a);
    b = turned(b);
    const Rational slope = (Rational(b.y) - a.y) / (Rational(b.x) - a.x);
    const Rational off = Rational(triangle.reach()) * (Rational(1) + slope.Abs());
    for (const auto& [low, high] : {stretch->first, stretch->last}) {
      const Rational on_edge = slope * (Rational(turned(low).x) - a.x) + a.y;
      const Rational above = Rational(turned(high).y) - on_edge - off;
      const Rational below = on_edge - off - turned(low).y;
      ASSERT_GE(above.Sign(), 0) << k;
      ASSERT_GE(below.Sign(), 0) << k;
      ASSERT_LT(std::max(above, below).ToDouble(), room) << k;
    }
    const double near = turned(stretch->rises ? stretch->first[0] : stretch->last[0]).x;
    const Rational start = Rational(a.x) + (stretch->rises ? 2 : -2) * triangle.reach();
    const Rational beyond = stretch->rises ? Rational(near) - start : start - near;
    ASSERT_GE(beyond.Sign(), 0) << k;
    ASSERT_LT(beyond.ToDouble(), room) << k;
  }
  EXPECT_GT(tried, 10000);
}

TEST(JudgeJointly, KeepsEdgesWithinTheGuardBand) {
  Profile set = *PresetProfile("vulkan");
  for (const std::optional<GuardBand>& band :
       {std::optional<GuardBand>(), std::optional<GuardBand>(AroundTarget{64}),
        std::optional<GuardBand>(WindowBox{-1, -1, 64, 9})}) {
    set.guard_band = band;
    EXPECT_EQ(LegalityOfLeaving(set, 7, 1), Legality::kLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 2), Legality::kNotLegal);
  }
  set.guard_band = AroundTarget{55};
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kLegal);
  set = *PresetProfile("d3d11");  // a step is 1/256
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
}

// ---- the moved edge is straight -----------------------------------------------------------------

constexpr int kLong = 40;
constexpr double kReach = 0x1p-4;  // a step of the coarsest grid that Vulkan lets

// A triangle under an edge from `a`, in the target, to `b`, far to its right; offsets move the edge
// down by so much at either end of what is seen of it, and linearly in between.
struct LeavingEdge {
  Point2 a;
  Point2 b;

  double Slope() const { return (b.y - a.y) / (b.x - a.x); }
  double Reach() const { return kReach * (1 + std::fabs(Slope())); }
  double Below(Point2 p) const { return p.y - (a.y + Slope() * (p.x - a.x)); }
  bool Covers(Point2 p, double at_first, double at_last) const {
    if (p.x < a.x) return false;
    const double part = (p.x - a.x) / (kLong - a.x);
    return Below(p) > at_first + part * (at_last - at_first);
  }

  Scene AsScene() const {
    Scene scene;
    scene.width = kLong;
    scene.height = 8;
    scene.precision = Precision::kFloat64;
    scene.vertices = {{a.x, a.y}, {b.x, b.y}, {a.x, 300}};
    scene.triangles = {{0, 1, 2}};
    return scene;
  }
};

// Ends on a grid of six bits, no sample above the first of them.
LeavingEdge ARandomEdge(std::mt19937_64& random) {
  const auto on_grid = [&](double low, double high) {
    return std::floor(std::uniform_real_distribution(low, high)(random) * 64) / 64;
  };
  return {{on_grid(1, 1.375), on_grid(2, 3)}, {on_grid(60, 400), on_grid(-60, 120)}};
}

struct Offsets {
  double at_first = 0;
  double at_last = 0;
};

Offsets ARandomMove(const LeavingEdge& edge, std::mt19937_64& random) {
  std::uniform_real_distribution<double> off(-edge.Reach(), edge.Reach());
  return {off(random), off(random)};
}

// The edge moved by the one up to a column, and by the other from there.
CoverageCounts BentImage(const LeavingEdge& edge, const Offsets& before, const Offsets& behind,
                         int column) {
  CoverageCounts counts(kLong, 8);
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < kLong; ++x) {
      const Offsets& by = x < column ? before : behind;
      const bool covered = edge.Covers({x + 0.5, row + 0.5}, by.at_first, by.at_last);
      counts.front[counts.Index(x, row, 0)] = covered ? 1 : 0;
    }
  }
  return counts;
}

Legality LegalityOf(const LeavingEdge& edge, const CoverageCounts& drawn) {
  Observed observed;
  observed.together = &drawn;
  return JudgeJointly(edge.AsScene(), {*PresetProfile("vulkan"), edge.AsScene()}, observed)
      .legality;
}

// By trying moves, not all of them.
bool IsDrawnByOneOfMany(const LeavingEdge& edge, const CoverageCounts& drawn) {
  constexpr int kTried = 48;
  for (int i = -kTried; i <= kTried; ++i) {
    for (int j = -kTried; j <= kTried; ++j) {
      const Offsets by{edge.Reach() * i / kTried, edge.Reach() * j / kTried};
      if (BentImage(edge, by, by, 0) == drawn) return true;
    }
  }
  return false;
}

TEST(JudgeJointly, LetsAnEdgeThatLeavesMoveAsOneStraightLine) {
  std::mt19937_64 random(20261124);
  int other = 0;
  for (int n = 0; n < 300; ++n) {
    const LeavingEdge edge = ARandomEdge(random);
    const Offsets by = ARandomMove(edge, random);
    const CoverageCounts drawn = BentImage(edge, by, by, 0);
    EXPECT_EQ(LegalityOf(edge, drawn), Legality::kLegal) << n;
    if (!(drawn == BentImage(edge, {}, {}, 0))) ++other;
  }
  EXPECT_GT(other, 100) << "what is drawn is not what the edge as given covers";
}

TEST(JudgeJointly, FindsABentEdgeThatNoStraightOneExplains) {
  std::mt19937_64 random(5);
  int found = 0;
  for (int n = 0; n < 2000; ++n) {
    const LeavingEdge edge = ARandomEdge(random);
    const int column = std::uniform_int_distribution<int>(8, kLong - 8)(random);
    const CoverageCounts drawn =
        BentImage(edge, ARandomMove(edge, random), ARandomMove(edge, random), column);
    if (LegalityOf(edge, drawn) == Legality::kLegal) continue;
    ++found;
    EXPECT_FALSE(IsDrawnByOneOfMany(edge, drawn)) << n;
  }
  EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace rasterproof::legal
