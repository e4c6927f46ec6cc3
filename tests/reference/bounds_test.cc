#include "reference/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/ulp.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "reference/method.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;

/// The floating-point methods that show edge values, and what a search must reach of their bounds.
struct Searched {
  std::string_view method;
  double fresh_floor;  ///< of the bound at one point
  double walk_floor;   ///< of the bound along a walk
};
constexpr std::array kSearched{
    Searched{"f32-direct", 0.7, 0.5},
    Searched{"f32-direct-fma", 0.6, 0.4},
    Searched{"f32-kahan", 0.7, 0.5},
    Searched{"f32-affine", 0.4, 0.2},
    Searched{"f32-affine-fma", 0.4, 0.2},
    Searched{"f32-incremental", 0.7, 0.5},
    Searched{"f32-incremental-row", 0.7, 0.5},
    Searched{"f32-incremental-16", 0.7, 0.5},
    Searched{"f32-incremental-compensated", 0.7, 0.3},
    Searched{"f32-index", 0.7, 0.5},
    Searched{"f32-index-fma", 0.7, 0.5},
    Searched{"f64-direct", 0.6, 0.4},
    Searched{"f64-kahan", 0.6, 0.4},
    Searched{"f64-incremental", 0.6, 0.4},
};

bool IsSingle(std::string_view method) { return method.starts_with("f32"); }

const EdgeEvaluator& EdgesOf(std::string_view method) { return *FindMethod(method)->edges; }

/// a.x, a.y, b.x, b.y, p.x, p.y.
using Coordinates = std::array<double, 6>;
Point2 A(const Coordinates& c) { return {c[0], c[1]}; }
Point2 B(const Coordinates& c) { return {c[2], c[3]}; }
Point2 P(const Coordinates& c) { return {c[4], c[5]}; }

/// |shown - exact| / bound, checked to be at most 1; 0 where no bound is stated.
double Ratio(double shown, const Rational& exact, double bound) {
  if (std::isnan(bound)) return 0;
  EXPECT_TRUE(std::isfinite(shown));
  const Rational error = (Rational(shown) - exact).Abs();
  if (bound == 0) {
    EXPECT_EQ(error.Sign(), 0) << "claimed to be exact";
    return 0;
  }
  EXPECT_LE(error, Rational(bound));
  return (error / bound).ToDouble();
}

double NextCoordinate(RandomValues& random, bool single, double x) {
  const auto step = static_cast<std::int64_t>(random.Bits(random.Integer(1, single ? 20 : 48)));
  const std::int64_t moved = random.Coin() ? step : -step;
  return single ? double{MoveByUlps(static_cast<float>(x), moved)} : MoveByUlps(x, moved);
}

/// Climbs towards the coordinates with the largest objective, restarting a few times.
template <class Objective>
double Climb(std::uint64_t seed, bool single, int evaluations, const Objective& objective) {
  RandomValues random(seed);
  Coordinates best{};
  double local = 0;
  double worst = 0;
  const int restarts = 4;
  for (int n = 0; n < evaluations; ++n) {
    const int phase = n % std::max(evaluations / restarts, 1);
    Coordinates c = best;
    if (phase == 0) local = 0;
    if (phase < 60) {
      for (double& x : c) {
        x = single ? double{random.LogUniform<float>(-1, 3)} : random.LogUniform<double>(-1, 3);
      }
    } else {
      double& x = c[static_cast<std::size_t>(random.Integer(0, 5))];
      x = NextCoordinate(random, single, x);
    }
    const double value = objective(c);
    if (value >= local) {
      local = value;
      best = c;
    }
    worst = std::max(worst, value);
  }
  return worst;
}

TEST(BoundsTest, NoSearchExceedsTheBoundOfAFreshValue) {
  for (const Searched& s : kSearched) {
    const EdgeEvaluator& edges = EdgesOf(s.method);
    const double worst = Climb(41, IsSingle(s.method), Cases(12000), [&](const Coordinates& c) {
      return Ratio(edges.Value(A(c), B(c), P(c)), exact::EdgeValue(A(c), B(c), P(c)),
                   edges.ErrorBound(A(c), B(c), P(c)));
    });
    std::printf("[ MEASURED ] %-28s fresh value: error / bound %.3f\n",
                std::string(s.method).c_str(), worst);
    EXPECT_LE(worst, 1) << s.method;
    EXPECT_GT(worst, s.fresh_floor / (kOneCaseIn > 1 ? 4 : 1)) << s.method;
  }
}

/// The exact values along a walk.
std::vector<Rational> ExactWalk(const Coordinates& c, const Step& step, int steps) {
  const Rational start = exact::EdgeValue(A(c), B(c), P(c));
  const Rational difference = step.along_y ? Rational(c[0]) - c[2] : Rational(c[3]) - c[1];
  const Rational add = difference * Rational(step.sign * step.length);
  std::vector<Rational> values{start};
  for (int n = 0; n < steps; ++n) values.push_back(values.back() + add);
  return values;
}

double WalkRatio(const EdgeEvaluator& edges, const Coordinates& c, const Step& step, int steps) {
  const auto shown = edges.Steps(A(c), B(c), P(c), step, steps);
  const auto bounds = edges.SteppingErrorBounds(A(c), B(c), P(c), step, steps);
  const auto exact = ExactWalk(c, step, steps);
  EXPECT_EQ(shown.size(), exact.size());
  EXPECT_EQ(bounds.size(), exact.size());
  double worst = 0;
  for (std::size_t n = 0; n < exact.size(); ++n) {
    worst = std::max(worst, Ratio(shown[n], exact[n], bounds[n]));
  }
  return worst;
}

Step RandomStep(RandomValues& random) {
  constexpr std::array kLengths{1, 1, 2, 3, 8, 16, 100};
  return {random.Coin(), random.Coin() ? 1 : -1,
          kLengths[static_cast<std::size_t>(random.Integer(0, 6))]};
}

TEST(BoundsTest, NoSearchExceedsTheBoundsAlongAWalk) {
  for (const Searched& s : kSearched) {
    const EdgeEvaluator& edges = EdgesOf(s.method);
    RandomValues steps(42);
    Step step = RandomStep(steps);
    int n = 0;
    const double worst = Climb(43, IsSingle(s.method), Cases(1500), [&](const Coordinates& c) {
      if (n++ % 400 == 0) step = RandomStep(steps);
      Coordinates at = c;  // samples lie on a lattice that a walk can represent
      at[4] = std::round(c[4] * 16) / 16;
      at[5] = std::round(c[5] * 16) / 16;
      return WalkRatio(edges, at, step, 24);
    });
    std::printf("[ MEASURED ] %-28s walk of 24 steps: error / bound %.3f\n",
                std::string(s.method).c_str(), worst);
    EXPECT_LE(worst, 1) << s.method;
    EXPECT_GT(worst, s.walk_floor / (kOneCaseIn > 1 ? 4 : 1)) << s.method;
  }
}

/// Coordinates of every kind that bounds have to survive.
Coordinates HardCoordinates(RandomValues& random, bool single, int kind) {
  Coordinates c{};
  const auto any = [&] {
    return single ? double{random.AnyFinite<float>()} : random.AnyFinite<double>();
  };
  const auto log = [&](int low, int high) {
    return single ? double{random.LogUniform<float>(low, high)}
                  : random.LogUniform<double>(low, high);
  };
  const int tiny = single ? -149 : -1074;
  const int huge = single ? 127 : 1023;
  for (double& x : c) {
    switch (kind) {
      case 0:
        x = any();
        break;
      case 1:  // products underflow
        x = log(tiny / 2 - 4, tiny / 2 + 8);
        break;
      case 2:  // subnormal
        x = log(tiny, tiny + 30);
        break;
      case 3:  // near overflow
        x = log(huge / 2 - 3, huge / 2 + 2);
        break;
      case 4:  // a coarse lattice: everything is exact
        x = random.Integer(-2048, 2048) / 256.0;
        break;
      case 5:  // both ends
        x = random.Coin() ? log(tiny / 2, 0) : log(0, huge / 2);
        break;
      default:  // far from the origin
        x = (single ? 4096 : 0x1p40) + random.Integer(0, 4096) / 1024.0;
    }
  }
  if (random.Integer(0, 3) == 0) c[4] = c[0];
  if (random.Integer(0, 3) == 0) c[5] = c[1];
  if (random.Integer(0, 7) == 0) c[3] = c[1];
  return c;
}

TEST(BoundsTest, HoldAtBothEndsOfTheRangeAndOnEveryLattice) {
  for (const Searched& s : kSearched) {
    const EdgeEvaluator& edges = EdgesOf(s.method);
    RandomValues random(44);
    int exact = 0;
    int none = 0;
    int stated = 0;
    for (int n = 0; n < Cases(2100); ++n) {
      const Coordinates c = HardCoordinates(random, IsSingle(s.method), n % 7);
      const double bound = edges.ErrorBound(A(c), B(c), P(c));
      Ratio(edges.Value(A(c), B(c), P(c)), exact::EdgeValue(A(c), B(c), P(c)), bound);
      exact += bound == 0 ? 1 : 0;
      none += std::isnan(bound) ? 1 : 0;
      stated += bound > 0 ? 1 : 0;
      if (n % 8 == 0) WalkRatio(edges, c, RandomStep(random), 18);
    }
    EXPECT_GT(exact, Cases(200)) << s.method;
    EXPECT_GT(none, Cases(100)) << s.method;
    EXPECT_GT(stated, Cases(600)) << s.method;
  }
}

TEST(BoundsTest, AreZeroWhereTheLatticeProvesTheValueExactAndOnlyThere) {
  // A box of 16 px on 1/256 px has sides of 4096 steps, whose square is 2^24.
  const EdgeEvaluator& edges = EdgesOf("f32-direct");
  RandomValues random(45);
  for (int n = 0; n < Cases(5000); ++n) {
    const auto in_box = [&] {
      return Point2{random.Integer(0, 4096) / 256.0, random.Integer(0, 4096) / 256.0};
    };
    ASSERT_EQ(edges.ErrorBound(in_box(), in_box(), in_box()), 0);
  }
  // One step further 4097 * 4097 is odd and has 25 bits: the float has to round it.
  const Point2 a{0, 0};
  const Point2 b{0, 4097 / 256.0};
  const Point2 p{4097 / 256.0, 0};
  EXPECT_GT(edges.ErrorBound(a, b, p), 0);
  EXPECT_NE(Rational(edges.Value(a, b, p)), exact::EdgeValue(a, b, p));
  // Walks too: 15 steps inside the box are exact, the step that leaves it need not be.
  for (const std::string_view method : {"f32-incremental", "f32-incremental-compensated",
                                        "f32-index", "f32-index-fma", "f32-incremental-16"}) {
    const auto bounds =
        EdgesOf(method).SteppingErrorBounds({0, 1 / 256.0}, {1, 16}, {0.5, 0.5}, Step{}, 15);
    for (const double bound : bounds) EXPECT_EQ(bound, 0) << method;
  }
}

TEST(BoundsTest, ValuesAtTheEndsOfAnEdgeAreZeroExactly) {
  RandomValues random(46);
  const EdgeEvaluator& direct = EdgesOf("f32-direct");
  for (int n = 0; n < Cases(2000); ++n) {
    const Coordinates c = HardCoordinates(random, true, n % 7);
    const double bound = direct.ErrorBound(A(c), B(c), A(c));
    if (!std::isnan(bound)) {
      EXPECT_EQ(bound, 0);
      EXPECT_EQ(direct.Value(A(c), B(c), A(c)), 0);
    }
  }
}

TEST(BoundsTest, NothingIsStatedWhereAResultMightOverflowOrIsNoNumber) {
  const double huge = std::numeric_limits<float>::max();
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Searched& s : kSearched) {
    if (!IsSingle(s.method)) continue;
    const EdgeEvaluator& edges = EdgesOf(s.method);
    EXPECT_TRUE(std::isnan(edges.ErrorBound({-huge, 0}, {huge, 1}, {0.5, 0.5}))) << s.method;
    EXPECT_TRUE(std::isnan(edges.ErrorBound({1e20, 1e20}, {-1e20, 3e20}, {0.5, 0.5}))) << s.method;
    for (const double bad : {inf, -inf, nan, 0.1}) {  // 0.1 is no float32
      EXPECT_TRUE(std::isnan(edges.ErrorBound({0, 0}, {1, 1}, {bad, 0}))) << s.method;
      for (const double bound : edges.SteppingErrorBounds({0, bad}, {1, 1}, {0, 0}, Step{}, 3)) {
        EXPECT_TRUE(std::isnan(bound)) << s.method;
      }
    }
  }
  // A walk that runs into overflow keeps its bounds up to there, and no further.
  const auto bounds =
      EdgesOf("f32-incremental")
          .SteppingErrorBounds({0, 0}, {0, 0x1p110}, {0.5, 0.5}, {false, 1, 4096}, 99);
  EXPECT_FALSE(std::isnan(bounds.front()));
  EXPECT_TRUE(std::isnan(bounds.back()));
}

TEST(BoundsTest, IncrementalDriftIsLinearInTheStepsOfABinade) {
  // The vertical edge x = 16384 with dY = 1 + 2.5 2^-10, walked from x = 1/2: the error grows in
  // one direction until the edge is pixels away from where it should be.
  const Coordinates c{16384, 0, 16384, 1 + 2.5 * 0x1p-10, 0.5, 0.5};
  const int steps = 16384;
  const double norm = c[3];
  const auto exact = ExactWalk(c, Step{}, steps);
  const auto displacement = [&](std::string_view method) {
    const EdgeEvaluator& edges = EdgesOf(method);
    const auto shown = edges.Steps(A(c), B(c), P(c), Step{}, steps);
    const auto bounds = edges.SteppingErrorBounds(A(c), B(c), P(c), Step{}, steps);
    double worst = 0;
    double ratio = 0;
    for (std::size_t n = 0; n < exact.size(); n += 64) {
      ratio = std::max(ratio, Ratio(shown[n], exact[n], bounds[n]));
      worst = std::max(worst, std::fabs((Rational(shown[n]) - exact[n]).ToDouble()) / norm);
    }
    std::printf("[ MEASURED ] %-28s 16384 steps: %.3g px off, error / bound %.3f\n",
                std::string(method).c_str(), worst, ratio);
    return worst;
  };
  EXPECT_GT(displacement("f32-incremental"), 1.0);
  EXPECT_LE(displacement("f32-incremental"), 0x1p28 * 0x1p-25);  // n^2 2^-25 px
  EXPECT_LT(displacement("f32-incremental-16"), 0.01);
  EXPECT_LT(displacement("f32-incremental-compensated"), 0.01);
  EXPECT_LT(displacement("f32-index"), 0.01);
  EXPECT_LT(displacement("f32-index-fma"), 0.01);
  EXPECT_LT(displacement("f64-incremental"), 1e-8);
}

TEST(BoundsTest, TheConstantsAreTheNumbersThatTheScriptsProve) {
  // proofs/edge_direct.g, edge_kahan.g, edge_affine.g write them as integers times powers of two.
  constexpr double kU = 0x1p-24;
  EXPECT_EQ(kDirectEdgeErrorMultiplier<float> * kU, std::ldexp(50331656, -48));
  EXPECT_EQ(kDirectFmaEdgeErrorMultiplier<float> * kU, std::ldexp(50331656, -48));
  EXPECT_EQ(kKahanEdgeErrorMultiplier<float> * kU, std::ldexp(33554439, -48));
  // The script has 2 + u: 2 + 4u is the next number that double has, too.
  EXPECT_EQ(kKahanEdgeRelError<float>, std::ldexp(33554436, -48));
  EXPECT_EQ(kAffineLineErrorMultiplier<float> * kU, std::ldexp(67108871, -48));
  EXPECT_EQ(kAffineConstantErrorMultiplier<float> * kU, std::ldexp(50331652, -48));
  EXPECT_EQ(kAffineFmaLineErrorMultiplier<float> * kU, std::ldexp(50331652, -48));
  EXPECT_EQ(kAffineFmaConstantErrorMultiplier<float> * kU, std::ldexp(67108871, -48));
  // In double the same polynomials of u are rounded to 53 bits; RoundBoundUp covers that.
  EXPECT_NEAR(kDirectEdgeErrorMultiplier<double>, 3 + 0x1p-50, 0x1p-51);
}

TEST(BoundsTest, LatticeExponentIsThatOfTheLowestSetBit) {
  EXPECT_EQ(LatticeExponent(1), 0);
  EXPECT_EQ(LatticeExponent(-6), 1);
  EXPECT_EQ(LatticeExponent(0.75), -2);
  EXPECT_EQ(LatticeExponent(0x1p-1074), -1074);
  EXPECT_EQ(LatticeExponent(0x1p-1073 + 0x1p-1074), -1074);
  EXPECT_EQ(LatticeExponent(std::numeric_limits<double>::max()), 971);
  EXPECT_EQ(LatticeExponent(0.0), kAnyLattice);
  EXPECT_EQ(LatticeExponent(-0.0), kAnyLattice);
}

TEST(BoundsTest, ASumRoundsByHalfAnUlpOrNotAtAll) {
  EXPECT_EQ(SumRoundingError(Precision::kFloat32, 0x1p24, 0), 0);
  EXPECT_EQ(SumRoundingError(Precision::kFloat32, 0x1p24 + 1, 0), 1);
  EXPECT_EQ(SumRoundingError(Precision::kFloat32, 1.5, -100), 0x1p-24);
  EXPECT_EQ(SumRoundingError(Precision::kFloat32, 0x1p-126, -149), 0);
  EXPECT_EQ(SumRoundingError(Precision::kFloat64, 1.5, -100), 0x1p-53);
  EXPECT_TRUE(std::isnan(
      SumRoundingError(Precision::kFloat64, std::numeric_limits<double>::infinity(), 0)));
}

TEST(BoundsTest, MagnitudeBoundIsNoLessThanTheValue) {
  RandomValues random(47);
  for (int n = 0; n < Cases(4200); ++n) {
    const Coordinates c = HardCoordinates(random, n % 2 == 0, n % 7);
    const double bound = EdgeMagnitudeBound(A(c), B(c), P(c));
    if (!std::isfinite(bound)) continue;
    ASSERT_LE(exact::EdgeValue(A(c), B(c), P(c)).Abs(), Rational(bound));
  }
}

}  // namespace
}  // namespace rasterproof::reference
