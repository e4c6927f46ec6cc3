// The exact methods on every finite double; all methods without a crash.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "library/exact_sign.h"
#include "model/snap_scene.h"
#include "tests/reference/brute_force.h"
#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"

namespace rasterproof::reference {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// A coordinate of a kind that goes wrong somewhere: huge, tiny, on a centre, an ulp beside one.
double UglyCoordinate(RandomValues& random) {
  switch (random.Integer(0, 8)) {
    case 0:
      return random.AnyFinite<double>();
    case 1:
      return random.LogUniform<double>(-1074, 1023);
    case 2:
      return random.Coin() ? kMax : -kMax;
    case 3:
      return random.Integer(-3, 3) * kTiny;
    case 4:
      return random.LogUniform<double>(90, 110);
    case 5:
      return MoveByUlps(random.Integer(0, 8) * 0.5, random.Integer(-2, 2));
    case 6:
      return random.Integer(0, 16) * 0.5;
    case 7:
      return random.Uniform(-4, 12);
    default:
      return random.Coin() ? -0.0 : 0.0;
  }
}

Scene UglyScene(RandomValues& random, int width, int height) {
  Scene scene = WindowScene(width, height, {{}, {}, {}});
  scene.precision = Precision::kFloat64;
  for (Vertex& v : scene.vertices) v = {UglyCoordinate(random), UglyCoordinate(random), 0, 1};
  if (random.Integer(0, 9) == 0) scene.vertices[1] = scene.vertices[0];
  return scene;
}

TEST(ExtremesTest, ExactMethodsAgreeWithBruteForceOnUglyFloat64) {
  RandomValues random(11);
  std::uint64_t covered = 0;
  for (int n = 0; n < 1500; ++n) {
    const Scene scene = UglyScene(random, 6, 5);
    const CoverageCounts expected = BruteForceCounts(scene);
    for (const std::string name : {"spans-exact", "filtered-exact"}) {
      const CoverageDifference d = Compare(Draw(scene, name), expected);
      EXPECT_EQ(d.wrong, 0U) << name << " scene " << n;
      covered += d.covered;
    }
  }
  EXPECT_GT(covered, 3000U);
}

TEST(ExtremesTest, ExactMethodsAgreeWithBruteForceOnAnUlpBesideCentres) {
  // Both ends of an edge on either side of a centre, an ulp off the straight line through it.
  RandomValues random(12);
  std::uint64_t covered = 0;
  for (int n = 0; n < 1500; ++n) {
    const Point2 centre{random.Integer(0, 5) + 0.5, random.Integer(0, 4) + 0.5};
    const Point2 a{random.LogUniform<double>(-8, 12), random.LogUniform<double>(-8, 12)};
    const double along = -random.LogUniform<double>(-4, 4);
    const Point2 b{MoveByUlps(centre.x + along * (a.x - centre.x), random.Integer(-1, 1)),
                   MoveByUlps(centre.y + along * (a.y - centre.y), random.Integer(-1, 1))};
    Scene scene = WindowScene(6, 5, {a, b, {random.Uniform(-6, 12), random.Uniform(-6, 12)}});
    scene.precision = Precision::kFloat64;
    const CoverageCounts expected = BruteForceCounts(scene);
    for (const std::string name : {"spans-exact", "filtered-exact"}) {
      const CoverageDifference d = Compare(Draw(scene, name), expected);
      EXPECT_EQ(d.wrong, 0U) << name << " scene " << n;
      covered += d.covered;
    }
  }
  EXPECT_GT(covered, 3000U);
}

TEST(ExtremesTest, SignsSurviveProductsThatUnderflowOrOverflow) {
  EXPECT_EQ(library::EdgeSign({0, 0}, {1e-200, 1e-200}, {2e-200, 3e-200}), -1);
  EXPECT_EQ(library::EdgeSign({0, 0}, {1e200, 1e200}, {2e200, 3e200}), -1);
  EXPECT_EQ(library::EdgeSign({-kMax, -kMax}, {kMax, kMax}, {0.5, 0.5}), 0);
  EXPECT_EQ(library::EdgeSign({-kMax, -kMax}, {kMax, kMax}, {0.5, MoveByUlps(0.5, 1)}), -1);
  EXPECT_EQ(library::EdgeSign({0, 0}, {kTiny, kTiny}, {kMax, kMax}), 0);
  EXPECT_EQ(library::EdgeSign({0, 0}, {kTiny, 2 * kTiny}, {kMax, kMax}), 1);
}

TEST(ExtremesTest, EveryTierDecidesAsBruteForceDoes) {
  RandomValues random(13);
  int filter = 0;
  int zero = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] { return Point2{UglyCoordinate(random), UglyCoordinate(random)}; };
    const Point2 a = point();
    const Point2 b = n % 3 == 0 ? Point2{a.y, a.x} : point();
    const Point2 p = n % 5 == 0 ? Point2{b.x / 2, b.y / 2} : point();
    const int expected = BruteForceEdgeSign(a, b, p);
    EXPECT_EQ(library::EdgeSign(a, b, p), expected);
    EXPECT_EQ(library::UnfilteredEdgeSign(a, b, p), expected);
    EXPECT_EQ(library::ExactEdge(a, b, p).Sign(), expected);
    filter += library::FilterEdge(a, b, p).certain ? 1 : 0;
    zero += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(filter, 2000);
  EXPECT_LT(filter, 18000);
  EXPECT_GT(zero, 200);
}

// Under the sanitizers this is where an unguarded conversion or a row out of bounds shows.
TEST(ExtremesTest, NoMethodWritesOutsideOrCrashesWhateverTheCoordinates) {
  RandomValues random(14);
  for (int n = 0; n < 1500; ++n) {
    Scene scene = UglyScene(random, 7, 3);
    if (n % 4 == 0) scene.vertices[2].x = std::numeric_limits<double>::quiet_NaN();
    Scene narrow = scene;
    narrow.precision = Precision::kFloat32;
    for (Vertex& v : narrow.vertices) {
      const double largest = std::numeric_limits<float>::max();
      v.x = static_cast<float>(std::fmax(-largest, std::fmin(largest, v.x)));
      v.y = static_cast<float>(std::fmax(-largest, std::fmin(largest, v.y)));
    }
    for (const std::string& name : WindowMethods()) {
      const bool is_float32 = FindMethod(name)->info.input == Precision::kFloat32;
      RasterOptions options;
      options.tile = n % 5;
      const CoverageCounts counts = Draw(is_float32 ? narrow : scene, name, options);
      for (std::size_t i = 0; i < counts.size(); ++i) ASSERT_LE(counts.Count(i), 1U) << name;
    }
  }
}

TEST(ExtremesTest, InfiniteEdgeValuesNeverCover) {
  RandomValues random(16);
  const EdgeEvaluator& edges = *FindMethod("f32-direct")->edges;
  const Point2 p{0.5, 0.5};
  int would_cover = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] {
      return Point2{random.LogUniform<float>(56, 72), random.LogUniform<float>(56, 72)};
    };
    const std::array<Point2, 3> v{point(), point(), point()};
    const double area = edges.Value(v[0], v[1], v[2]);
    const int next = area > 0 ? 1 : 2;
    bool all_positive = area > 0 || area < 0;
    bool any_infinite = false;
    for (int i = 0; i < 3; ++i) {
      const double e = edges.Value(v[static_cast<std::size_t>(i * next % 3)],
                                   v[static_cast<std::size_t>((i + 1) * next % 3)], p);
      all_positive = all_positive && e > 0;
      any_infinite = any_infinite || std::isinf(e);
    }
    if (!all_positive || !any_infinite) continue;
    ++would_cover;
    EXPECT_EQ(Draw(WindowScene(1, 1, {v[0], v[1], v[2]}), "f32-direct").Count(0), 0U);
  }
  EXPECT_GT(would_cover, 100);
}

TEST(ExtremesTest, SnappedMethodsStayExactBeyondTheirIntegers) {
  RandomValues random(15);
  for (const std::string name : {"i64-snap8", "i32-snap4"}) {
    const Profile& profile = FindMethod(name)->info.profile;
    std::uint64_t covered = 0;
    for (int n = 0; n < 400; ++n) {
      const double reach = profile.coordinate_limit * random.Uniform(0.9, 1.1);
      const auto coordinate = [&] {
        return random.Coin() ? random.Uniform(-reach, reach) : random.Integer(-1, 1) * reach;
      };
      Scene scene = WindowScene(5, 5,
                                {{coordinate(), coordinate()},
                                 {coordinate(), coordinate()},
                                 {coordinate(), coordinate()}});
      scene.precision = Precision::kFloat64;
      const CoverageDifference d =
          Compare(Draw(scene, name), BruteForceCounts(SnapScene(scene, {profile, scene})));
      EXPECT_EQ(d.wrong, 0U) << name << " scene " << n;
      covered += d.covered;
    }
    EXPECT_GT(covered, 1000U);
  }
}

}  // namespace
}  // namespace rasterproof::reference
