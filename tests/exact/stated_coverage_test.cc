// Fixed-point input, largest extents, models by target, the exclusive rule: the oracle against
// pictures drawn by hand, and against rationals that wrap, snap and measure on their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "exact/coverage.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {
namespace {

using Picture = std::vector<std::string>;

Scene MakeScene(int width, int height, std::vector<Vertex> vertices,
                std::vector<Triangle> triangles) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.precision = Precision::kFloat64;
  scene.vertices = std::move(vertices);
  scene.triangles = std::move(triangles);
  return scene;
}

Picture PictureOf(const Scene& scene, const Profile& profile) {
  const CoverageCounts counts = Coverage(scene, profile);
  EXPECT_EQ(counts, Coverage(scene, profile, {}, Decider::kIntegers));
  EXPECT_EQ(counts, Coverage(scene, profile, {}, Decider::kCgal));
  Picture rows;
  for (int row = 0; row < counts.height; ++row) {
    std::string text;
    for (int i = 0; i < counts.width; ++i) {
      text += std::to_string(counts.Count(counts.Index(i, row)));
    }
    rows.push_back(text);
  }
  return rows;
}

TEST(Coverage, WrapsFixedPointCoordinates) {
  Profile profile;
  profile.fixed = FixedInput{12, 4, true, true};
  // (0, 0), (3, 0), (0, 3), each some spans away.
  const Scene scene = MakeScene(3, 3, {{4096, -4096}, {3 - 8192, 0}, {0, 4099}}, {{0, 1, 2}});
  EXPECT_EQ(PictureOf(scene, profile), (Picture{"110", "100", "000"}));
  profile.fixed->wraps = false;
  EXPECT_NE(PictureOf(scene, profile), (Picture{"110", "100", "000"}));
}

TEST(Coverage, DropsWhatIsLargerThanTheLargestExtent) {
  Profile profile;
  profile.snap = {4};
  profile.max_primitive_extent = MaxPrimitiveExtent{4, 3};
  const auto picture = [&](double x, double y) {
    return PictureOf(MakeScene(3, 2, {{0, 0}, {x, 0}, {0, y}}, {{0, 1, 2}}), profile);
  };
  EXPECT_EQ(picture(4, 3), (Picture{"111", "110"}));
  EXPECT_EQ(picture(4 + 0x1p-4, 3), (Picture{"000", "000"}));
  EXPECT_EQ(picture(4, 3 + 0x1p-4), (Picture{"000", "000"}));
  EXPECT_EQ(picture(4, 3 + 0x1p-6), (Picture{"111", "110"}));
}

TEST(Coverage, SnapsAsTheModelOfTheTargetDoes) {
  Profile profile;
  profile.snap = {0, SnapRule::kFloor};
  TargetModel small;
  small.max_width = small.max_height = 3;
  small.snap = {8};
  profile.by_target_size.push_back(small);
  const std::vector<Vertex> vertices{{0.75, 0}, {0.75, 4}, {9, 0}};
  EXPECT_EQ(PictureOf(MakeScene(3, 1, vertices, {{0, 1, 2}}), profile), (Picture{"011"}));
  EXPECT_EQ(PictureOf(MakeScene(4, 1, vertices, {{0, 1, 2}}), profile), (Picture{"1111"}));
}

TEST(Coverage, LeavesEveryEdgeOutUnderTheExclusiveRule) {
  Profile profile;
  profile.tie_rule = {.exclusive = true};
  // A square from centre to centre, cut along its diagonal: only what no edge passes is inside.
  const Scene square =
      MakeScene(5, 5, {{0.5, 0.5}, {4.5, 0.5}, {4.5, 4.5}, {0.5, 4.5}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(PictureOf(square, profile), (Picture{"00000", "00110", "01010", "01100", "00000"}));
  profile.tie_rule = {.inclusive = true};
  EXPECT_EQ(PictureOf(square, profile), (Picture{"21111", "12111", "11211", "11121", "11112"}));
}

TEST(Coverage, OfClipSpaceHasNoFixedPointInput) {
  Scene scene = MakeScene(3, 3, {{0, 0}, {3, 0}, {0, 3}}, {{0, 1, 2}});
  scene.clip_space = true;
  Profile profile;
  profile.fixed = FixedInput{};
  EXPECT_THROW(Coverage(scene, profile), InputError);
  profile.fixed.reset();
  profile.max_primitive_extent = MaxPrimitiveExtent{8, 8};
  EXPECT_THROW(Coverage(scene, profile), InputError);
}

// x - 2^n floor((x - least) / 2^n), and then floor to multiples of 2^-bits.
double Placed(double x, const FixedInput& fixed, int bits) {
  const mpq_class span = NaiveTwoTo(fixed.integer_bits);
  const mpq_class least = fixed.is_signed ? mpq_class(-span / 2) : mpq_class(0);
  const auto floored = [](const mpq_class& q) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), q.get_num_mpz_t(), q.get_den_mpz_t());
    return mpq_class(whole);
  };
  const mpq_class from_least = (mpq_class(x) - least) / span;
  const mpq_class wrapped = mpq_class(x) - span * floored(from_least);
  const mpq_class scale = NaiveTwoTo(bits);
  return mpq_class(floored(wrapped * scale) / scale).get_d();
}

class Random {
 public:
  std::int64_t Int(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(bits_);
  }

 private:
  std::mt19937_64 bits_{7};
};

Profile DrawProfile(Random& random) {
  Profile profile;
  profile.fixed = FixedInput{static_cast<int>(random.Int(3, 6)), 4, random.Int(0, 1) == 0, true};
  profile.snap = {static_cast<int>(random.Int(0, 4)), SnapRule::kFloor};
  profile.max_primitive_extent = MaxPrimitiveExtent{static_cast<double>(random.Int(2, 40)), 12.25};
  constexpr std::array<TieRule, 4> kRules{
      {{}, {-1, +1, true}, {.inclusive = true}, {.exclusive = true}}};
  profile.tie_rule = kRules[static_cast<std::size_t>(random.Int(0, 3))];
  return profile;
}

// Half pixels as often as not, so that edges pass through samples; some of them spans away.
double DrawCoordinate(Random& random, const FixedInput& fixed) {
  const std::int64_t at = random.Int(0, 1) == 0 ? 8 * random.Int(-3, 20) : random.Int(-20, 150);
  const std::int64_t spans = random.Int(0, 2) == 0 ? random.Int(-3, 3) : 0;
  return static_cast<double>(at) / 16 + static_cast<double>(spans) * fixed.Span();
}

mpq_class ExtentOf(double a, double b, double c) {
  return mpq_class(std::max({a, b, c})) - mpq_class(std::min({a, b, c}));
}

CoverageCounts RationalCoverage(const Scene& scene, const Profile& profile) {
  Scene placed = scene;
  std::vector<Vertex>& v = placed.vertices;
  for (Vertex& corner : v) {
    corner.x = Placed(corner.x, *profile.fixed, profile.snap.bits);
    corner.y = Placed(corner.y, *profile.fixed, profile.snap.bits);
  }
  if (ExtentOf(v[0].x, v[1].x, v[2].x) > profile.max_primitive_extent->width ||
      ExtentOf(v[0].y, v[1].y, v[2].y) > profile.max_primitive_extent->height) {
    placed.triangles.clear();
  }
  Profile plain;
  plain.tie_rule = profile.tie_rule;
  return NaiveCoverage(placed, plain);
}

TEST(Coverage, OfWrappedSnappedAndDroppedTrianglesIsThatOfRationals) {
  Random random;
  int drawn = 0, unlike_plain = 0;
  for (int k = 0; k < 1500; ++k) {
    Profile profile = DrawProfile(random);
    Scene scene = MakeScene(7, 6, {}, {{0, 1, 2}});
    for (int v = 0; v < 3; ++v) {
      const double x = DrawCoordinate(random, *profile.fixed);
      scene.vertices.push_back({x, DrawCoordinate(random, *profile.fixed), 0, 1});
    }
    const CoverageCounts truth = RationalCoverage(scene, profile);
    for (const Decider decider : {Decider::kFast, Decider::kIntegers, Decider::kCgal}) {
      ASSERT_EQ(Coverage(scene, profile, {}, decider), truth) << k;
    }
    drawn += truth == CoverageCounts(7, 6, 1) ? 0 : 1;
    profile.fixed.reset();
    profile.max_primitive_extent.reset();
    unlike_plain += Coverage(scene, profile) == truth ? 0 : 1;
  }
  EXPECT_GT(drawn, 100);
  EXPECT_GT(unlike_plain, 100);
}

TEST(Coverage, UnderTheExclusiveRuleIsThatOfRationalsOfQuarterPixels) {
  Profile profile;
  profile.tie_rule = {.exclusive = true};
  std::mt19937_64 random(11);
  for (int k = 0; k < 3000; ++k) {
    // Quarter pixels: flat and vertical edges, vertices on samples, collinear corners.
    Scene scene = MakeScene(5, 5, {}, {{0, 1, 2}});
    scene.clip_space = k % 3 == 0;
    for (int v = 0; v < 3; ++v) {
      const auto coordinate = [&] { return static_cast<double>(random() % 28) / 4 - 1; };
      const double w = scene.clip_space ? static_cast<double>(1 + random() % 2) : 1;
      const double x = coordinate() * w;
      scene.vertices.push_back({x, coordinate() * w, 0, w});
    }
    profile.y_axis = k % 2 == 0 ? YAxis::kDown : YAxis::kUp;
    const CoverageCounts truth = NaiveCoverage(scene, profile);
    ASSERT_EQ(Coverage(scene, profile), truth) << k;
    ASSERT_EQ(Coverage(scene, profile, {}, Decider::kIntegers), truth) << k;
  }
}

}  // namespace
}  // namespace rasterproof::exact
