// Walks along rows and columns: what drifts, what does not, and by how much at most.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "library/exact_sign.h"
#include "reference/edge_values.h"
#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

constexpr float kDriftDy = 1 + 2.5F * 0x1p-10F;  // half of every step's last bit is rounded one way

double ExactE(Point2 a, Point2 b, Point2 p) { return library::ExactEdge(a, b, p).ToDouble(); }

TEST(WalkTest, TheDriftWitnessMovesAnIncrementalEdgeByPixels) {
  const Point2 a{16384, 0};
  const Point2 b{16384, kDriftDy};
  const Point2 start{0.5, 0.5};
  const auto drift = [&](const char* method) {
    const std::vector<double> walk = FindMethod(method)->edges->Steps(a, b, start, {}, 16384);
    return std::fabs(walk.back() - ExactE(a, b, {16384.5, 0.5})) / kDriftDy;
  };
  EXPECT_GT(drift("f32-incremental"), 3.9);
  EXPECT_LT(drift("f32-incremental"), 4.01);  // n^2 2^-26 pixels
  EXPECT_LT(drift("f32-incremental-16"), 0.02);
  EXPECT_LT(drift("f32-index"), 1e-3);
  EXPECT_LT(drift("f32-index-fma"), 1e-3);
  EXPECT_LT(drift("f32-direct"), 1e-6);
  EXPECT_LT(drift("f32-incremental-compensated"), 3e-3);
  EXPECT_EQ(drift("f64-incremental"), 0);
}

TEST(WalkTest, TheDriftShowsInCoverageAndTheIndexFormHasNone) {
  // A row 16384 samples long up to a vertical edge. This dY drifts inwards: the row ends too early.
  // (The witness above drifts outwards, where the box hides it.)
  constexpr float kDy = 1 + 3.5F * 0x1p-10F;
  const Scene scene = WindowScene(16400, 2, {{16384, 0}, {0, 0.5}, {16384, kDy}});
  const auto wrong = [&](const char* method) {
    return Compare(Draw(scene, method), Draw(scene, "spans-exact")).wrong;
  };
  EXPECT_GE(wrong("f32-incremental"), 3U);
  EXPECT_GE(wrong("f32-incremental-row"), 3U);
  EXPECT_EQ(wrong("f32-incremental-16"), 0U);
  EXPECT_EQ(wrong("f32-index"), 0U);
  EXPECT_EQ(wrong("f32-index-fma"), 0U);
  EXPECT_EQ(wrong("f32-direct"), 0U);
}

// Where all arithmetic is exact, every walk in every direction arrives where a fresh value does.
TEST(WalkTest, WalksOfSmallLatticeScenesEqualFreshValuesInAllEightDirections) {
  RandomValues random(31);
  for (int n = 0; n < Cases(200); ++n) {
    const auto point = [&] {
      return Point2{random.Integer(0, 64) * 0.5, random.Integer(0, 64) * 0.5};
    };
    const Point2 a = point();
    const Point2 b = point();
    const Point2 p{random.Integer(0, 31) + 0.5, random.Integer(0, 31) + 0.5};
    for (const Method& method : Methods()) {
      if (!method.info.takes_window) continue;
      for (const bool along_y : {false, true}) {
        for (const int sign : {-1, 1}) {
          for (const int length : {1, 3, 8}) {
            const Step step{along_y, sign, length};
            const std::vector<double> walk = method.edges->Steps(a, b, p, step, 20);
            ASSERT_EQ(walk.size(), 21U);
            for (int k = 0; k <= 20; ++k) {
              const double moved = sign * length * k;
              const Point2 at{p.x + (along_y ? 0 : moved), p.y + (along_y ? moved : 0)};
              ASSERT_EQ(walk[static_cast<std::size_t>(k)], ExactE(a, b, at)) << method.name;
              ASSERT_EQ(method.edges->Value(a, b, at), ExactE(a, b, at)) << method.name;
            }
          }
        }
      }
    }
  }
}

/// Largest error / bound over a walk; 0 / 0 counts as 0, an error above a bound of 0 as infinite.
double WorstRatio(const EdgeEvaluator& edges, Point2 a, Point2 b, Point2 p, Step step, int steps) {
  const std::vector<double> walk = edges.Steps(a, b, p, step, steps);
  const std::vector<double> bounds = edges.SteppingErrorBounds(a, b, p, step, steps);
  EXPECT_EQ(walk.size(), bounds.size());
  double worst = 0;
  for (int n = 0; n <= steps; ++n) {
    const auto i = static_cast<std::size_t>(n);
    if (std::isnan(bounds[i])) continue;
    const double moved = static_cast<double>(step.sign) * step.length * n;
    library::ExactSum error = library::ExactEdge(
        a, b, {p.x + (step.along_y ? 0 : moved), p.y + (step.along_y ? moved : 0)});
    error.Subtract(walk[i], 1.0);
    if (error.Sign() == 0) continue;
    worst = std::max(worst, std::fabs(error.ToDouble()) / bounds[i]);
  }
  return worst;
}

TEST(WalkTest, ErrorsOfEveryMethodStayWithinTheBoundsItStates) {
  RandomValues random(32);
  for (const Method& method : Methods()) {
    if (!method.info.takes_window) continue;
    double worst = 0;
    for (int n = 0; n < 150; ++n) {
      const int high = random.Integer(2, 14);
      const auto coordinate = [&] { return double{random.LogUniform<float>(-6, high)}; };
      const Point2 a{coordinate(), coordinate()};
      const Point2 b{coordinate(), coordinate()};
      const Point2 p{random.Integer(0, 4095) + 0.5, random.Integer(0, 4095) + 0.5};
      const Step step{random.Coin(), random.Coin() ? 1 : -1, 1 << random.Integer(0, 3)};
      worst = std::max(worst, WorstRatio(*method.edges, a, b, p, step, 64));
      if (method.canonical_edges != nullptr) {
        worst = std::max(worst, WorstRatio(*method.canonical_edges, a, b, p, step, 64));
      }
    }
    EXPECT_LE(worst, 1) << method.name;
    const bool shows_exact_values = method.info.states_exact && method.info.profile.snap.IsNone();
    EXPECT_TRUE(shows_exact_values || worst > 0.02)
        << method.name << " was hardly tested: " << worst;
  }
}

TEST(WalkTest, IntegerValuesOfGridPointsAreExactAndOffGridOnesBounded) {
  RandomValues random(33);
  const EdgeEvaluator& edges = *FindMethod("i64-snap8")->edges;
  for (int n = 0; n < 500; ++n) {
    const auto grid = [&] { return random.Integer(-1 << 20, 1 << 20) * 0x1p-8; };
    const Point2 a{grid(), grid()};
    const Point2 b{grid(), grid()};
    const Point2 p{grid(), grid()};
    EXPECT_EQ(edges.ErrorBound(a, b, p), 0);
    EXPECT_EQ(edges.Value(a, b, p), ExactE(a, b, p));
    const Point2 off{a.x + 0x1p-10, a.y - 0x1p-9};
    EXPECT_LE(std::fabs(edges.Value(off, b, p) - ExactE(off, b, p)), edges.ErrorBound(off, b, p));
  }
}

TEST(WalkTest, CanonicalValuesAreAntisymmetricBitByBit) {
  RandomValues random(34);
  for (const Method& method : Methods()) {
    if (method.canonical_edges == nullptr) continue;
    for (int n = 0; n < 300; ++n) {
      const auto point = [&] {
        return Point2{random.LogUniform<float>(-4, 12), random.LogUniform<float>(-4, 12)};
      };
      const Point2 a = point();
      Point2 b = point();
      if (n % 3 == 1) b.x = a.x;
      if (n % 3 == 2) b.y = a.y;
      const Point2 p{random.Integer(0, 999) + 0.5, random.Integer(0, 999) + 0.5};
      EXPECT_EQ(method.canonical_edges->Value(a, b, p), -method.canonical_edges->Value(b, a, p))
          << method.name;
    }
  }
}

}  // namespace
}  // namespace rasterproof::reference
