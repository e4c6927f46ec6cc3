#include "reference/homogeneous.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/ulp.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "library/triple_sum.h"
#include "reference/homogeneous_edges.h"
#include "reference/rasterize.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

Scene ClipScene(int width, int height, std::vector<Vertex> vertices,
                std::vector<Triangle> triangles, Precision precision = Precision::kFloat32) {
  Scene scene;
  scene.name = "clip";
  scene.width = width;
  scene.height = height;
  scene.precision = precision;
  scene.clip_space = true;
  scene.vertices = std::move(vertices);
  scene.triangles = std::move(triangles);
  return scene;
}

CoverageCounts DrawBy(const Scene& scene, std::string_view method,
                      const RasterOptions& options = {}) {
  CoverageCounts counts(scene.width, scene.height);
  Rasterize(scene, *FindMethod(method), options, counts);
  return counts;
}

std::uint64_t Total(const CoverageCounts& counts) {
  std::uint64_t total = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) total += counts.Count(k);
  return total;
}

/// A vertex of a kind that makes homogeneous coverage hard.
Vertex HardVertex(RandomValues& random, int kind) {
  const auto f = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  switch (kind) {
    case 0:  // small integers, many ties, w of either sign or zero
      return {double(random.Integer(-8, 8)), double(random.Integer(-8, 8)), 0,
              double(random.Integer(-2, 2))};
    case 1: {  // in front, near the eye
      const double w = f(std::ldexp(1 + random.Uniform(0, 1), random.Integer(-12, 0)));
      return {f(random.Uniform(-4, 12) * w), f(random.Uniform(-4, 12) * w), 0, w};
    }
    case 2:  // both ends of the exponent range
      return {random.LogUniform<float>(-140, 127), random.LogUniform<float>(-140, 127), 0,
              random.LogUniform<float>(-140, 127)};
    default:  // ordinary, mixed signs
      return {f(random.Uniform(-8, 8)), f(random.Uniform(-8, 8)), 0, f(random.Uniform(-1, 1))};
  }
}

TEST(TripleSumTest, SignIsRightAcrossTheWholeRangeOfDouble) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  library::TripleSum sum;
  EXPECT_EQ(sum.Sign(), 0);
  sum.Add(huge, huge, huge);
  sum.Add(tiny, tiny, -tiny);
  EXPECT_EQ(sum.Sign(), 1);
  sum.Subtract(huge, huge, huge);
  EXPECT_EQ(sum.Sign(), -1);
  sum.Add(tiny, tiny, tiny);
  EXPECT_EQ(sum.Sign(), 0);
  sum.Add(0.0, huge, -huge);
  EXPECT_EQ(sum.Sign(), 0);
}

TEST(TripleSumTest, SignAgreesWithRationalsOnRandomTriples) {
  RandomValues random(1);
  for (int n = 0; n < Cases(2000); ++n) {
    library::TripleSum sum;
    exact::Rational expected;
    for (int k = 0; k < 6; ++k) {
      const auto x = random.AnyFinite<double>();
      const double y = random.LogUniform<double>(-30, 30);
      const double z = random.Integer(-3, 3);
      // Every other product is taken back, so that sums cancel down to nothing.
      sum.Add(x, y, z);
      expected += exact::Rational(x) * y * z;
      if (random.Coin()) {
        sum.Subtract(x, y, z);
        expected -= exact::Rational(x) * y * z;
      }
    }
    ASSERT_EQ(sum.Sign(), expected.Sign());
  }
}

TEST(HomogeneousEdgeTest, ValueIsTheScaledProjectedEdgeByHand) {
  // V0 = (1, 0, 2), V1 = (0, 1, 1): projected (1/2, 0) and (0, 1). At p = (1/2, 1/2):
  // E = (0)(1) - (1/2)(-1/2) = 1/4, and w0 w1 E = 1/2.
  const Vertex v0{1, 0, 0, 2};
  const Vertex v1{0, 1, 0, 1};
  const HomogeneousNormal<double> n(v0, v1);
  EXPECT_EQ(n.Dot(0.5, 0.5, 1), 0.5);
  EXPECT_EQ(exact::HomogeneousEdgeValue(v0, v1, {0.5, 0.5}), exact::Rational(0.5));
  // A published form anchors at the unprojected V0: (p - V0) x (V1/w1 - V0/w0) = -1/4 here.
  const double anchored = (0.5 - 1) * (1 - 0) - (0.5 - 0) * (0 - 0.5);
  EXPECT_EQ(anchored, -0.25);
}

TEST(HomogeneousEdgeTest, ExactSignsAgreeWithTheOracleForEveryKindOfVertex) {
  RandomValues random(2);
  for (int n = 0; n < Cases(20000); ++n) {
    const int kind = n % 4;
    std::array<Vertex, 3> v{HardVertex(random, kind), HardVertex(random, kind),
                            HardVertex(random, kind)};
    if (n % 3 == 0) v[2].x = random.AnyFinite<double>();
    if (n % 5 == 0) v[2] = {v[0].x + v[1].x, v[0].y + v[1].y, 0, v[0].w + v[1].w};
    if (!IsFinite(v[2])) continue;
    const Point2 p{random.Integer(-16, 16) / 2.0, random.Integer(-16, 16) / 2.0};
    ASSERT_EQ(ExactHomogeneousSign(v[0], v[1], p), exact::HomogeneousEdgeSign(v[0], v[1], p));
    ASSERT_EQ(ExactHomogeneousFacing(v[0], v[1], v[2]), exact::HomogeneousFacing(v));
  }
}

TEST(HomogeneousEdgeTest, ReversedEdgeIsTheNegativeBitByBit) {
  RandomValues random(3);
  for (int n = 0; n < Cases(20000); ++n) {
    const Vertex a = HardVertex(random, 3);
    const Vertex b = HardVertex(random, 3);
    const HomogeneousNormal<float> ab(a, b);
    const HomogeneousNormal<float> ba(b, a);
    const auto x = static_cast<float>(random.Integer(0, 16)) + 0.5F;
    const auto y = static_cast<float>(random.Integer(0, 16)) + 0.5F;
    ASSERT_EQ(ab.Dot(x, y, 1), -ba.Dot(x, y, 1));
  }
}

TEST(HomogeneousMethodsTest, ExactMethodEqualsTheOracleAtEverySample) {
  RandomValues random(4);
  std::uint64_t covered = 0;
  std::uint64_t behind = 0;
  for (int n = 0; n < Cases(3000); ++n) {
    const int kind = n % 4;
    std::vector<Vertex> vertices;
    for (int k = 0; k < 5; ++k) vertices.push_back(HardVertex(random, kind));
    for (const Vertex& v : vertices) behind += v.w <= 0 ? 1 : 0;
    const Scene scene =
        ClipScene(8, 8, vertices, {{0, 1, 2}, {2, 1, 3}, {3, 4, 0}, {1, 1, 2}, {4, 2, 0}});
    const CoverageCounts expected = exact::Coverage(scene, Profile{});
    ASSERT_EQ(DrawBy(scene, "hom-exact"), expected) << "case " << n;
    covered += Total(expected);
  }
  EXPECT_GT(covered, Cases(20000U));
  EXPECT_GT(behind, Cases(3000U));
}

TEST(HomogeneousMethodsTest, ExactMethodServesEveryRuleLatticeAndAxis) {
  RandomValues random(5);
  std::vector<TieRule> rules{TieRule{.inclusive = true}};
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const bool y_first : {false, true}) {
        rules.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), y_first});
      }
    }
  }
  for (int n = 0; n < Cases(1000); ++n) {
    Profile profile;
    profile.tie_rule = rules[static_cast<std::size_t>(n) % rules.size()];
    profile.y_axis = random.Coin() ? YAxis::kUp : YAxis::kDown;
    if (random.Coin()) profile.pattern.locations = {{0, 0}, {0.5, 0.5}, {0.25, 0.9375}};
    std::vector<Vertex> vertices;
    for (int k = 0; k < 4; ++k) vertices.push_back(HardVertex(random, n % 2 == 0 ? 0 : 3));
    const Scene scene = ClipScene(8, 8, vertices, {{0, 1, 2}, {2, 1, 3}});
    DrawOptions options;
    options.cull = static_cast<Cull>(random.Integer(0, 2));
    if (random.Coin()) options.scissor = PixelRect{1, 2, 7, 6};
    CoverageCounts counts(8, 8, profile.pattern.samples());
    DrawHomogeneousExact(scene, profile, options, counts);
    ASSERT_EQ(counts, exact::Coverage(scene, profile, options)) << "case " << n;
  }
}

TEST(HomogeneousMethodsTest, FloatMethodsAreWithinTheirBoundOfEveryMisjudgedSample) {
  // A wrong sample has a computed edge within the proven error of zero: never a gross mistake,
  // whatever the signs of w.
  RandomValues random(6);
  std::uint64_t wrong = 0;
  std::uint64_t samples = 0;
  for (int n = 0; n < Cases(2000); ++n) {
    std::vector<Vertex> vertices;
    for (int k = 0; k < 3; ++k) vertices.push_back(HardVertex(random, n % 2 == 0 ? 0 : 3));
    const Scene scene = ClipScene(8, 8, vertices, {{0, 1, 2}});
    const CoverageCounts expected = DrawBy(scene, "hom-exact");
    wrong += Compare(DrawBy(scene, "hom-f32"), expected).wrong;
    EXPECT_EQ(Compare(DrawBy(scene, "hom-f64"), expected).wrong, 0U) << "case " << n;
    samples += expected.size();
  }
  EXPECT_LE(wrong * 10000, samples);
}

TEST(HomogeneousMethodsTest, NeighboursShareEverySampleOfTheirEdgeInFloat) {
  // Quads split along a diagonal that passes through samples; N_ji = -N_ij leaves no gap.
  RandomValues random(7);
  for (int n = 0; n < Cases(2000); ++n) {
    const auto corner = [&](double x, double y) {
      const double w = 1 + random.Integer(0, 8);
      return Vertex{x * w, y * w, 0, w};
    };
    const Scene scene =
        ClipScene(16, 16, {corner(-9, -7), corner(23, -8), corner(25, 24), corner(-10, 25)},
                  {{0, 1, 2}, {0, 2, 3}});
    const CoverageCounts counts = DrawBy(scene, "hom-f32");
    for (std::size_t k = 0; k < counts.size(); ++k) ASSERT_EQ(counts.Count(k), 1U);
  }
}

TEST(HomogeneousMethodsTest, EyeInsideAClosedSurfaceIsSeenOnceInEveryDirection) {
  // A tetrahedron around the eye, window = (x/w, y/w): every ray with w > 0 leaves it once.
  const std::vector<Vertex> vertices{
      {-80, -70, 0, -10}, {10, -60, 0, -10}, {-40, 20, 0, -10}, {4, 4, 0, 1}};
  const Scene scene = ClipScene(8, 8, vertices, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  for (const std::string_view method : {"hom-f32", "hom-f64", "hom-exact"}) {
    const CoverageCounts counts = DrawBy(scene, method);
    for (std::size_t k = 0; k < counts.size(); ++k) {
      ASSERT_EQ(counts.Count(k), 1U) << method << " sample " << k;
      ASSERT_EQ(counts.Signed(k), counts.Signed(0)) << method << " sample " << k;
    }
  }
}

TEST(HomogeneousMethodsTest, WithoutTheDeterminantsSignHalfOfAllTrianglesWouldBeLost) {
  // The published test "every edge value positive" knows no winding: of a triangle and its
  // reversal it covers one. With the determinant's sign both are covered, by the same samples.
  const std::vector<Vertex> v{{1, 1, 0, 1}, {7, 2, 0, 1}, {3, 7, 0, 1}};
  const CoverageCounts one = DrawBy(ClipScene(8, 8, v, {{0, 1, 2}}), "hom-f32");
  const CoverageCounts other = DrawBy(ClipScene(8, 8, v, {{0, 2, 1}}), "hom-f32");
  EXPECT_GT(Total(one), 10U);
  EXPECT_EQ(one.front, other.back);
  EXPECT_EQ(one.back, other.front);
  const auto all_positive = [&](int a, int b, int c, Point2 p) {
    const auto edge = [&](int i, int j) {
      return HomogeneousNormal<float>(v[static_cast<std::size_t>(i)],
                                      v[static_cast<std::size_t>(j)])
          .Dot(static_cast<float>(p.x), static_cast<float>(p.y), 1);
    };
    return edge(a, b) > 0 && edge(b, c) > 0 && edge(c, a) > 0;
  };
  const Point2 inside{3.5, 3.5};
  EXPECT_NE(all_positive(0, 1, 2, inside), all_positive(0, 2, 1, inside));
}

TEST(HomogeneousMethodsTest, ProjectedAndScaledFormsAgreeInFrontAndFailBehindTheEye) {
  const std::vector<Vertex> front{{1, 1, 0, 1}, {14, 4, 0, 2}, {3, 7, 0, 1}};
  const Scene in_front = ClipScene(8, 8, front, {{0, 1, 2}});
  const CoverageCounts expected = DrawBy(in_front, "hom-exact");
  EXPECT_EQ(DrawBy(in_front, "hom-projected-f32"), expected);
  EXPECT_EQ(DrawBy(in_front, "hom-scaled-f32"), expected);

  // The same triangle through the eye's centre: wholly behind, so nothing may be seen.
  std::vector<Vertex> mirrored = front;
  for (Vertex& v : mirrored) v = {-v.x, -v.y, 0, -v.w};
  const Scene behind = ClipScene(8, 8, mirrored, {{0, 1, 2}});
  EXPECT_EQ(Total(DrawBy(behind, "hom-exact")), 0U);
  EXPECT_EQ(Total(DrawBy(behind, "hom-f32")), 0U);
  EXPECT_GT(Total(DrawBy(behind, "hom-projected-f32")), 10U);
  EXPECT_GT(Total(DrawBy(behind, "hom-scaled-f32")), 10U);

  // One vertex behind: the projected triangle lies elsewhere altogether.
  const Scene mixed = ClipScene(8, 8, {{1, 1, 0, 1}, {7, 2, 0, 1}, {-3, -7, 0, -1}}, {{0, 1, 2}});
  const CoverageCounts truth = exact::Coverage(mixed, Profile{});
  EXPECT_GT(Total(truth), 0U);
  EXPECT_EQ(DrawBy(mixed, "hom-f32"), truth);
  EXPECT_GT(Compare(DrawBy(mixed, "hom-projected-f32"), truth).wrong, 0U);
  EXPECT_GT(Compare(DrawBy(mixed, "hom-scaled-f32"), truth).wrong, 0U);
}

TEST(HomogeneousMethodsTest, ExtremeAndNonFiniteInputDrawsNothingElse) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<float>::max();
  for (const double bad : {inf, -inf, nan, huge, -huge, 1e-45, 0.0}) {
    for (int place = 0; place < 9; ++place) {
      std::vector<Vertex> v{{1, 1, 0, 1}, {7, 2, 0, 1}, {3, 7, 0, 1}};
      Vertex& corner = v[static_cast<std::size_t>(place / 3)];
      (place % 3 == 0 ? corner.x : place % 3 == 1 ? corner.y : corner.w) = bad;
      const Scene scene = ClipScene(8, 8, v, {{0, 1, 2}});
      const CoverageCounts expected = exact::Coverage(scene, Profile{});
      EXPECT_EQ(DrawBy(scene, "hom-exact"), expected);
      for (const Method& method : HomogeneousMethods()) {
        const CoverageCounts counts = DrawBy(scene, method.name);
        if (!std::isfinite(bad)) {
          EXPECT_EQ(Total(counts), 0U) << method.name;
        }
        // Whatever rounding does, a single triangle covers no sample twice.
        for (std::size_t k = 0; k < counts.size(); ++k) EXPECT_LE(counts.Count(k), 1U);
      }
    }
  }
}

/// Climbs towards the largest |computed - exact| / (multiplier u T).
template <class T>
double WorstHomogeneousRatio(std::uint64_t seed) {
  RandomValues random(seed);
  double worst = 0;
  std::array<double, 8> best{};
  for (int n = 0; n < Cases(6000); ++n) {
    std::array<double, 8> c = best;
    if (n < Cases(200)) {
      for (double& x : c) x = random.LogUniform<T>(0, 2);
    } else {
      auto& x = c[static_cast<std::size_t>(random.Integer(0, 7))];
      x = MoveByUlps(static_cast<T>(x),
                     static_cast<std::int64_t>(random.Bits(random.Integer(1, 20))) -
                         static_cast<std::int64_t>(random.Bits(10)));
    }
    const Vertex vi{c[0], c[1], 0, c[2]};
    const Vertex vj{c[3], c[4], 0, c[5]};
    const T computed =
        HomogeneousNormal<T>(vi, vj).Dot(static_cast<T>(c[6]), static_cast<T>(c[7]), 1);
    const exact::Rational error =
        (exact::HomogeneousEdgeValue(vi, vj, {c[6], c[7]}) - double{computed}).Abs();
    const double magnitude = (std::fabs(c[4] * c[2]) + std::fabs(c[5] * c[1])) * std::fabs(c[6]) +
                             (std::fabs(c[5] * c[0]) + std::fabs(c[3] * c[2])) * std::fabs(c[7]) +
                             std::fabs(c[3] * c[1]) + std::fabs(c[4] * c[0]);
    const double ratio =
        error.ToDoubleUp() / (kHomogeneousErrorMultiplier<T> * rounding_epsilon<T>() * magnitude);
    if (ratio >= worst) {
      worst = ratio;
      best = c;
    }
  }
  return worst;
}

TEST(HomogeneousBoundTest, NoSearchExceedsTheErrorMultiplier) {
  const double single = WorstHomogeneousRatio<float>(8);
  const double full = WorstHomogeneousRatio<double>(9);
  std::printf("[ MEASURED ] homogeneous error / bound: float32 %.3f, float64 %.3f\n", single, full);
  EXPECT_LE(single, 1.0);
  EXPECT_LE(full, 1.0);
  EXPECT_GT(single, 0.2);
  EXPECT_GT(full, 0.2);
}

}  // namespace
}  // namespace rasterproof::reference
