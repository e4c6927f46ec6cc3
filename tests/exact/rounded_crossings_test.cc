// Coverage where crossings of rows are rounded, against a definition in GMP's rationals.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "exact/coverage.h"

namespace rasterproof::exact {
namespace {

mpz_class FloorOf(const mpq_class& x) {
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return floor;
}

mpq_class RoundedTo(const mpq_class& x, const Snap& grid) {
  const mpq_class unit(1, 1U << static_cast<unsigned>(grid.bits));
  const mpq_class steps = (x - mpq_class(grid.origin)) / unit;
  mpz_class n = FloorOf(steps);
  const mpq_class rest = steps - n;
  const mpq_class half(1, 2);
  bool up = false;
  switch (grid.rule) {
    case SnapRule::kFloor:
      break;
    case SnapRule::kHalfUp:
      up = rest >= half;
      break;
    case SnapRule::kTruncate:
      up = rest > 0 && steps < 0;
      break;
    case SnapRule::kNearestEven:
      up = rest > half || (rest == half && mpz_odd_p(n.get_mpz_t()) != 0);
      break;
    case SnapRule::kNearestAway:
      up = rest > half || (rest == half && steps > 0);
      break;
  }
  if (up) ++n;
  return mpq_class(grid.origin) + n * unit;
}

using Corners3 = std::array<Point2, 3>;

// Whether the sample lies between the rounded crossings of its row, by sorting what bounds it.
bool CoversByDefinition(Corners3 v, Point2 p, const Profile& profile) {
  const TieRule& rule = profile.tie_rule;
  std::ranges::sort(v, {}, &Point2::y);
  const bool in_rows =
      rule.sign_y > 0 ? v[0].y <= p.y && p.y < v[2].y : v[0].y < p.y && p.y <= v[2].y;
  if (!in_rows) return false;
  const auto crossing = [&](Point2 a, Point2 b) {
    const mpq_class slope = (mpq_class(b.x) - a.x) / (mpq_class(b.y) - a.y);
    return RoundedTo(mpq_class(a.x) + (mpq_class(p.y) - a.y) * slope, profile.scanline_rounding);
  };
  const bool upper = rule.sign_y > 0 ? p.y < v[1].y : p.y <= v[1].y;
  mpq_class left = crossing(v[0], v[2]);
  mpq_class right = upper ? crossing(v[0], v[1]) : crossing(v[1], v[2]);
  if (right < left) std::swap(left, right);
  return rule.sign_x > 0 ? left <= p.x && p.x < right : left < p.x && p.x <= right;
}

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : bits_(seed) {}
  int Int(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<unsigned>(high - low + 1));
  }
  // On a grid of halves to 2^-20, near or far.
  double Coordinate() {
    const double unit = std::ldexp(1.0, -Int(1, 20));
    const double reach = Int(0, 9) == 0 ? 0x1p20 : 12;
    return std::floor((static_cast<double>(bits_()) / 0x1p31 - 0.5) * reach / unit) * unit;
  }

 private:
  std::mt19937 bits_;
};

Profile DrawnProfile(Draw& draw) {
  Profile profile;
  constexpr std::array kBits{0, 1, 4, 8, 16};
  profile.scanline_rounding.bits = kBits[static_cast<std::size_t>(draw.Int(0, 4))];
  profile.scanline_rounding.rule = static_cast<SnapRule>(draw.Int(0, 4));
  if (draw.Int(0, 3) == 0) {
    profile.scanline_rounding.form = SnapForm::kExactDifference;
    profile.scanline_rounding.origin = 0.5;
  }
  profile.tie_rule.sign_x = draw.Int(0, 1) == 0 ? 1 : -1;
  profile.tie_rule.sign_y = draw.Int(0, 1) == 0 ? 1 : -1;
  return profile;
}

TEST(RoundedCrossings, AreThoseOfTheDefinition) {
  Draw draw(1);
  std::uint64_t covered = 0;
  std::uint64_t moved = 0;
  for (int n = 0; n < 2000; ++n) {
    const Profile profile = DrawnProfile(draw);
    Scene scene;
    scene.width = 8;
    scene.height = 6;
    scene.precision = Precision::kFloat64;
    Corners3 v{};
    for (Point2& p : v) {
      p = {draw.Coordinate(), draw.Coordinate()};
      scene.vertices.push_back({p.x, p.y, 0, 1});
    }
    scene.triangles = {{0, 1, 2}};
    if (Facing(v) == 0) continue;
    const CoverageCounts counts = Coverage(scene, profile);
    Profile real = profile;
    real.scanline_rounding = {};
    if (counts != Coverage(scene, real)) ++moved;
    for (int row = 0; row < scene.height; ++row) {
      for (int x = 0; x < scene.width; ++x) {
        const bool expected = CoversByDefinition(v, {x + 0.5, row + 0.5}, profile);
        ASSERT_EQ(counts.Count(counts.Index(x, row)), expected ? 1U : 0U)
            << "triangle " << n << ", pixel " << x << ", " << row;
        if (expected) ++covered;
      }
    }
  }
  EXPECT_GT(covered, 5000U);
  EXPECT_GT(moved, 200U);
}

// A crossing at 2 + 3/8 is rounded down to 2, or up to 3: the sample at 5/2 lies on either side.
TEST(RoundedCrossings, MoveASampleThatTheEdgeItselfDoesNot) {
  Scene scene;
  scene.width = 4;
  scene.height = 1;
  scene.vertices = {{2.375, 0, 0, 1}, {2.375, 1, 0, 1}, {-8, 1, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  profile.scanline_rounding = {0, SnapRule::kFloor};
  const auto count = [&](int x) {
    return Coverage(scene, profile).Count(static_cast<std::size_t>(x));
  };
  EXPECT_EQ(count(1), 1U);
  EXPECT_EQ(count(2), 0U);
  profile.scanline_rounding = {0, SnapRule::kHalfUp};
  EXPECT_EQ(count(1), 1U);
  profile.scanline_rounding = {
      1, SnapRule::kHalfUp};  // 2.375 becomes 5/2, which the right side does not own
  EXPECT_EQ(count(2), 0U);
  profile.tie_rule.sign_x = -1;
  EXPECT_EQ(count(2), 1U);
}

// The crossing lies 2^-54 below 2, and the double nearest to it is 2.
TEST(RoundedCrossings, AreRoundedOnce) {
  Scene scene;
  scene.width = 4;
  scene.height = 1;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{2, 0, 0, 1}, {2 - 0x1p-52, 2, 0, 1}, {-8, 2, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  profile.scanline_rounding = {0, SnapRule::kFloor};
  EXPECT_EQ(Coverage(scene, profile).Count(0), 1U);
  EXPECT_EQ(Coverage(scene, profile).Count(1), 0U);
  profile.scanline_rounding = {0, SnapRule::kHalfUp};
  EXPECT_EQ(Coverage(scene, profile).Count(1), 1U);
}

TEST(RoundedCrossings, ThatRationalsDecideAreNotCountedAsFiltered) {
  Scene scene;
  scene.width = 4;
  scene.height = 1;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{2, 0, 0, 1}, {2 - 0x1p-52, 2, 0, 1}, {-8, 2, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  profile.scanline_rounding = {0, SnapRule::kFloor};
  {
    const TierScope scope;
    Coverage(scene, profile);
    EXPECT_EQ(scope.Counts().exact, 1U) << "the right side crosses 2^-54 below 2";
  }
  scene.vertices[1].x = 1;
  const TierScope scope;
  Coverage(scene, profile);
  EXPECT_EQ(scope.Counts().exact, 0U) << "no crossing lies near a place where the rounding changes";
}

TEST(RoundedCrossings, AreNoMatterOfHomogeneousClipSpace) {
  Scene scene;
  scene.clip_space = true;
  Profile profile;
  profile.scanline_rounding = {8, SnapRule::kFloor};
  EXPECT_THROW(Coverage(scene, profile), InputError);
}

// A decider that would only repeat what the fast path says gives no second opinion.
TEST(RoundedCrossings, AreDecidedByTheFastPathAlone) {
  Scene scene;
  scene.width = 4;
  scene.height = 1;
  scene.vertices = {{2.375, 0, 0, 1}, {2.375, 1, 0, 1}, {-8, 1, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  profile.scanline_rounding = {8, SnapRule::kFloor};
  for (const Decider decider : {Decider::kIntegers, Decider::kCgal}) {
    EXPECT_THROW(Coverage(scene, profile, {}, decider), InputError);
    EXPECT_EQ(Coverage(scene, {}, {}, decider).Count(1), 1U);
  }
}

}  // namespace
}  // namespace rasterproof::exact
