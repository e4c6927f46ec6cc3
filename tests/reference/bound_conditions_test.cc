// Where a bound is stated, and what comes out where it is not: the condition in the coordinates,
// underflow, overflow, and what each form of comparison makes of infinity, NaN and -0.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "exact/edge.h"
#include "exact/rational.h"
#include "reference/bounds.h"
#include "reference/edge_ownership.h"
#include "reference/method.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;

constexpr std::array<std::string_view, 14> kFloatMethods{
    "f32-direct",          "f32-direct-fma",     "f32-kahan",
    "f32-affine",          "f32-affine-fma",     "f32-incremental",
    "f32-incremental-row", "f32-incremental-16", "f32-incremental-compensated",
    "f32-index",           "f32-index-fma",      "f64-direct",
    "f64-kahan",           "f64-incremental"};

double LargestCoordinate(std::string_view method) {
  return method.starts_with("f32") ? kNoOverflowCoordinate<float> : kNoOverflowCoordinate<double>;
}

/// Calls `visit` with every a, b, p of coordinates -size, 0 and size.
template <class Visit>
void VisitCorners(double size, const Visit& visit) {
  const std::array<double, 3> values{-size, 0, size};
  for (int n = 0; n < 729; ++n) {
    std::array<double, 6> c{};
    int digits = n;
    for (double& x : c) {
      x = values[static_cast<std::size_t>(digits % 3)];
      digits /= 3;
    }
    visit(Point2{c[0], c[1]}, Point2{c[2], c[3]}, Point2{c[4], c[5]});
  }
}

TEST(BoundConditions, ABoundIsStatedForAllCoordinatesUpToTheLimit) {
  for (const std::string_view method : kFloatMethods) {
    const EdgeEvaluator& edges = *FindMethod(method)->edges;
    VisitCorners(LargestCoordinate(method), [&](Point2 a, Point2 b, Point2 p) {
      const double bound = edges.ErrorBound(a, b, p);
      const double value = edges.Value(a, b, p);
      ASSERT_TRUE(std::isfinite(bound) && std::isfinite(value)) << method;
      ASSERT_LE((Rational(value) - exact::EdgeValue(a, b, p)).Abs(), Rational(bound)) << method;
    });
  }
}

TEST(BoundConditions, BeyondTheLimitNoBoundIsStatedWhereAResultIsNoNumber) {
  for (const std::string_view method : kFloatMethods) {
    const EdgeEvaluator& edges = *FindMethod(method)->edges;
    for (const double times : {2.0, 4.0}) {
      int none = 0;
      int lost = 0;  // no number, or an infinity
      VisitCorners(times * LargestCoordinate(method), [&](Point2 a, Point2 b, Point2 p) {
        const bool is_finite = std::isfinite(edges.Value(a, b, p));
        const bool is_stated = !std::isnan(edges.ErrorBound(a, b, p));
        ASSERT_TRUE(is_finite || !is_stated) << method;
        none += is_stated ? 0 : 1;
        lost += is_finite ? 0 : 1;
      });
      EXPECT_GT(none, 0) << method << ": the limit could be larger";
      EXPECT_EQ(lost > 0, times == 4) << method;
    }
  }
}

/// What decides the sign of a value, as rasterizers are written.
bool AtLeastZero(double e) { return e >= 0; }
bool NotNegative(double e) { return !(e < 0); }  // NOLINT: the form that is in use
bool NoSignBit(double e) { return !std::signbit(e); }

// Both products overflow: infinity less infinity.
constexpr Point2 kOrigin{0, 0};
constexpr Point2 kFar{0x1p65, 0x1p64};
constexpr Point2 kBeside{0x1p64, 0x1p66};  // E(kOrigin, kFar; kBeside) < 0 < E(.., kFar, kBelow)
constexpr Point2 kBelow{0x1p67, 0x1p64};

TEST(BoundConditions, NoNumberIsOutsideByOneComparisonAndInsideByItsNegation) {
  EXPECT_LT(exact::EdgeValue(kOrigin, kFar, kBeside).Sign(), 0);
  EXPECT_GT(exact::EdgeValue(kOrigin, kFar, kBelow).Sign(), 0);
  for (const std::string_view method : {"f32-direct", "f32-kahan", "f32-direct-fma"}) {
    const EdgeEvaluator& edges = *FindMethod(method)->edges;
    for (const Point2 p : {kBeside, kBelow}) {
      const double e = edges.Value(kOrigin, kFar, p);
      EXPECT_TRUE(std::isnan(edges.ErrorBound(kOrigin, kFar, p)));
      if (method == "f32-direct-fma") {  // the fused product does not overflow by itself
        EXPECT_EQ(e, std::numeric_limits<double>::infinity());
        continue;
      }
      ASSERT_TRUE(std::isnan(e)) << method;
      EXPECT_FALSE(AtLeastZero(e)) << "not covered, on either side";
      EXPECT_TRUE(NotNegative(e)) << "covered, on either side";
#if defined(__x86_64__)
      EXPECT_FALSE(NoSignBit(e)) << "an x86 processor sets the sign of the NaN that it makes";
#elif defined(__aarch64__)
      EXPECT_TRUE(NoSignBit(e)) << "an Arm processor does not";
#endif
      // What the methods do: never covered.
      EXPECT_FALSE(IsInside(static_cast<float>(e), InsideFrom<float>(true)));
      EXPECT_FALSE(IsInside(static_cast<float>(e), InsideFrom<float>(false)));
    }
  }
}

TEST(BoundConditions, AnInfinityHasTheSignOfTheProductThatOverflowed) {
  const EdgeEvaluator& edges = *FindMethod("f32-direct")->edges;
  // Only (p.x - a.x)(b.y - a.y) overflows, or only the other one: both signs are right.
  const Point2 up{1, 0x1p70};
  const double e = edges.Value(kOrigin, up, {0x1p70, 1});
  EXPECT_EQ(e, std::numeric_limits<double>::infinity());
  EXPECT_EQ(exact::EdgeValue(kOrigin, up, {0x1p70, 1}).Sign(), 1);
  EXPECT_TRUE(AtLeastZero(e) && NotNegative(e) && NoSignBit(e));
  EXPECT_FALSE(IsInside(static_cast<float>(e), 0.0F)) << "but no method here relies on it";
  const Point2 along{0x1p70, 1};
  const double f = edges.Value(kOrigin, along, {1, 0x1p70});
  EXPECT_EQ(f, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(exact::EdgeValue(kOrigin, along, {1, 0x1p70}).Sign(), -1);
  EXPECT_FALSE(AtLeastZero(f) || NotNegative(f) || NoSignBit(f));
  // A difference that overflows times zero is no number, though E is 0: p and the edge are level.
  const double huge = std::numeric_limits<float>::max();
  const double g = edges.Value({-huge, 0}, {0, 0}, {huge, 0});
  EXPECT_TRUE(std::isnan(g));
  EXPECT_EQ(exact::EdgeValue({-huge, 0}, {0, 0}, {huge, 0}).Sign(), 0);
}

TEST(BoundConditions, MinusZeroIsInsideByComparisonsAndOutsideByItsSignBit) {
  // 0 times -1 less 0 times 1: -0 less 0.
  const double e = FindMethod("f32-direct")->edges->Value({0, 0}, {1, -1}, {0, 0});
  EXPECT_EQ(e, 0);
  EXPECT_TRUE(AtLeastZero(e) && NotNegative(e));
  EXPECT_FALSE(NoSignBit(e));
}

TEST(BoundConditions, WithoutTheTermOfEtaAProductThatUnderflowsRefutesTheBound) {
  // 2^-75 times 2^-75 is 2^-150, half of eta, and rounds to 0.
  const Point2 b{0, 0x1p-75};
  const Point2 p{0x1p-75, 0};
  for (const std::string_view method : {"f32-direct", "f32-kahan", "f32-affine", "f32-index"}) {
    const EdgeEvaluator& edges = *FindMethod(method)->edges;
    const Rational exact = exact::EdgeValue({0, 0}, b, p);
    const Rational error = (Rational(edges.Value({0, 0}, b, p)) - exact).Abs();
    EXPECT_EQ(error, exact) << method;
    EXPECT_GT(error, exact * Rational(5 * 0x1p-24)) << "more than all relative terms together";
    EXPECT_LE(error, Rational(edges.ErrorBound({0, 0}, b, p))) << method;
  }
}

}  // namespace
}  // namespace rasterproof::reference
