#include "reference/barycentrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "core/ulp.h"
#include "exact/attributes.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;
using Triangle2 = std::array<Point2, 3>;

constexpr std::array kForms{BarycentricForm::kVertexArea, BarycentricForm::kSum,
                            BarycentricForm::kOneMinus, BarycentricForm::kUnsignedArea};
constexpr std::array kInterpolations{InterpolationForm::kBarycentrics, InterpolationForm::kDeltas,
                                     InterpolationForm::kPerspective};
constexpr std::array kDistances{WireframeForm::kBarycentric, WireframeForm::kDerivative,
                                WireframeForm::kHeight};

Point2 InPrecision(Precision precision, Point2 p) {
  if (precision == Precision::kFloat64) return p;
  return {static_cast<double>(static_cast<float>(p.x)),
          static_cast<double>(static_cast<float>(p.y))};
}

/// A triangle and a sample: ordinary ones, needles, far from the origin, subnormal, huge.
struct Shape {
  Triangle2 v;
  Point2 p;
};
Shape HardShape(RandomValues& random, Precision precision, int kind) {
  const bool single = precision == Precision::kFloat32;
  const double scale =
      kind == 3 ? (single ? 0x1p-70 : 0x1p-520) : (kind == 4 ? (single ? 0x1p60 : 0x1p505) : 1);
  const double far = kind == 2 ? 4096 : 0;
  Shape shape;
  for (Point2& q : shape.v) {
    q = {(far + random.Uniform(-8, 8)) * scale, (far + random.Uniform(-8, 8)) * scale};
  }
  if (kind == 1) {  // a needle: the third vertex almost on the line of the others
    const double t = random.Uniform(0, 1);
    const double width = std::ldexp(random.Uniform(-1, 1), random.Integer(-20, -3));
    shape.v[2] = {shape.v[0].x + t * (shape.v[1].x - shape.v[0].x) + width,
                  shape.v[0].y + t * (shape.v[1].y - shape.v[0].y)};
  }
  double a = random.Uniform(0, 1);
  double b = random.Uniform(0, 1 - a);
  if (random.Integer(0, 3) == 0) {  // outside
    a += 1;
    b -= 0.5;
  }
  const double c = 1 - a - b;
  shape.p = {a * shape.v[0].x + b * shape.v[1].x + c * shape.v[2].x,
             a * shape.v[0].y + b * shape.v[1].y + c * shape.v[2].y};
  for (Point2& q : shape.v) q = InPrecision(precision, q);
  shape.p = InPrecision(precision, shape.p);
  return shape;
}

/// Largest error / bound seen, and how often a bound was stated at all.
struct Observed {
  double worst = 0;
  std::uint64_t stated = 0;
  std::uint64_t asked = 0;

  void Add(const Rational& error, double bound) {
    ++asked;
    if (std::isnan(bound)) return;
    ++stated;
    ASSERT_LE(error.Abs(), Rational(bound));
    if (bound > 0) worst = std::max(worst, (error.Abs() / bound).ToDouble());
  }
  void Print(const std::string& what) const {
    std::printf("[ MEASURED ] %s: error / bound %.3f, stated %llu of %llu\n", what.c_str(), worst,
                static_cast<unsigned long long>(stated), static_cast<unsigned long long>(asked));
  }
};

class BarycentricsTest : public testing::TestWithParam<Precision> {
 protected:
  const BarycentricEvaluator& barycentrics() const { return ReferenceBarycentrics(GetParam()); }
  std::string name() const { return GetParam() == Precision::kFloat32 ? "f32 " : "f64 "; }
};
INSTANTIATE_TEST_SUITE_P(BothPrecisions, BarycentricsTest,
                         testing::Values(Precision::kFloat32, Precision::kFloat64),
                         [](const auto& tested) {
                           return tested.param == Precision::kFloat32 ? "Float32" : "Float64";
                         });

TEST_P(BarycentricsTest, AreThoseComputedByHand) {
  const Triangle2 v{Point2{0, 0}, Point2{4, 0}, Point2{0, 4}};
  for (const BarycentricForm form : kForms) {
    const auto l = barycentrics().Barycentrics(form, v, {1, 2});
    EXPECT_EQ(l, (std::array<double, 3>{0.25, 0.25, 0.5}));
  }
  const Triangle2 reversed{v[0], v[2], v[1]};
  for (const BarycentricForm form : kForms) {
    const auto l = barycentrics().Barycentrics(form, reversed, {1, 2});
    EXPECT_EQ(l, (std::array<double, 3>{0.25, 0.5, 0.25}));
  }
}

TEST_P(BarycentricsTest, UnsignedAreasMistakeAnOutsidePointForAnInsideOne) {
  const Triangle2 v{Point2{0, 0}, Point2{4, 0}, Point2{0, 4}};
  const Point2 outside{2, -1};
  EXPECT_EQ(barycentrics().Barycentrics(BarycentricForm::kVertexArea, v, outside),
            (std::array<double, 3>{0.75, 0.5, -0.25}));
  const auto l = barycentrics().Barycentrics(BarycentricForm::kUnsignedArea, v, outside);
  EXPECT_EQ(l, (std::array<double, 3>{0.75, 0.5, 0.25}));
  // So it states nothing there, and something on the closed triangle.
  for (const double bound :
       barycentrics().BarycentricErrorBounds(BarycentricForm::kUnsignedArea, v, outside)) {
    EXPECT_TRUE(std::isnan(bound));
  }
  EXPECT_TRUE(std::isnan(barycentrics().SumErrorBound(BarycentricForm::kUnsignedArea, v, outside)));
  for (const Point2 p : {Point2{1, 1}, Point2{0, 0}, Point2{2, 2}, Point2{0, 3}}) {
    for (const double bound :
         barycentrics().BarycentricErrorBounds(BarycentricForm::kUnsignedArea, v, p)) {
      EXPECT_FALSE(std::isnan(bound));
    }
  }
}

TEST_P(BarycentricsTest, StayWithinTheirBounds) {
  for (const BarycentricForm form : kForms) {
    Observed barycentric;
    Observed sum;
    RandomValues random(11);
    for (int n = 0; n < Cases(2000); ++n) {
      const Shape s = HardShape(random, GetParam(), n % 5);
      const auto exact = exact::Barycentrics(s.v, s.p);
      const auto l = barycentrics().Barycentrics(form, s.v, s.p);
      const auto bounds = barycentrics().BarycentricErrorBounds(form, s.v, s.p);
      const double sum_bound = barycentrics().SumErrorBound(form, s.v, s.p);
      if (!exact) {
        for (const double bound : bounds) EXPECT_TRUE(std::isnan(bound));
        continue;
      }
      Rational total = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(l[i])) {
          ASSERT_TRUE(std::isnan(bounds[i]));
          ASSERT_TRUE(std::isnan(sum_bound));
          continue;
        }
        barycentric.Add(Rational(l[i]) - (*exact)[i], bounds[i]);
        total += l[i];
      }
      if (!std::isnan(sum_bound)) sum.Add(total, sum_bound);
    }
    const std::string form_name = std::to_string(static_cast<int>(form));
    barycentric.Print(name() + "barycentrics, form " + form_name);
    sum.Print(name() + "sum of barycentrics, form " + form_name);
    EXPECT_GT(barycentric.worst, 0.1);
    EXPECT_GT(sum.worst, 0.1);
    EXPECT_GT(barycentric.stated * 2, barycentric.asked);
  }
}

/// The largest |l0 + l1 + l2 - 1| in units of u that a climb finds inside triangles.
template <class T>
double WorstSum(BarycentricForm form, std::uint64_t seed) {
  constexpr Precision kPrecision =
      sizeof(T) == sizeof(float) ? Precision::kFloat32 : Precision::kFloat64;
  const BarycentricEvaluator& barycentrics = ReferenceBarycentrics(kPrecision);
  RandomValues random(seed);
  std::array<double, 8> best{};
  double worst = -1;
  for (int n = 0; n < Cases(10000); ++n) {
    std::array<double, 8> c = best;
    if (n % 2500 < 200) {
      const Shape s = HardShape(random, kPrecision, 0);
      c = {s.v[0].x, s.v[0].y, s.v[1].x, s.v[1].y, s.v[2].x, s.v[2].y, s.p.x, s.p.y};
    } else {
      double& x = c[static_cast<std::size_t>(random.Integer(0, 7))];
      const auto step = static_cast<std::int64_t>(random.Bits(random.Integer(1, 12)));
      x = MoveByUlps(static_cast<T>(x), random.Coin() ? step : -step);
    }
    const Triangle2 v{Point2{c[0], c[1]}, Point2{c[2], c[3]}, Point2{c[4], c[5]}};
    const auto l = barycentrics.Barycentrics(form, v, {c[6], c[7]});
    if (!(l[0] >= 0 && l[1] >= 0 && l[2] >= 0 && l[0] <= 1)) continue;
    // Exact: barycentrics in [0, 1] of either precision; the largest part goes first.
    const double u = rounding_epsilon<T>();
    const double off = sizeof(T) == sizeof(float)
                           ? std::fabs(((l[0] + l[1]) + l[2]) - 1) / u
                           : (Rational(l[0]) + l[1] + l[2] - 1).Abs().ToDouble() / u;
    if (off >= worst) {
      worst = off;
      best = c;
    }
  }
  return worst;
}

TEST(BarycentricsSumTest, NormalizedSumsStayWithinTheirBoundInside) {
  const double single = WorstSum<float>(BarycentricForm::kSum, 12);
  const double full = WorstSum<double>(BarycentricForm::kSum, 13);
  std::printf("[ MEASURED ] sum over the float sum, inside: %.3f u (f32), %.3f u (f64)\n", single,
              full);
  EXPECT_LE(single, kNormalizedSumErrorMultiplier<float>);
  EXPECT_LE(full, kNormalizedSumErrorMultiplier<double>);
  EXPECT_GT(std::min(single, full), 0.5);
}

TEST(BarycentricsSumTest, OneMinusSumsStayWithinOneRoundingInside) {
  const double single = WorstSum<float>(BarycentricForm::kOneMinus, 14);
  const double full = WorstSum<double>(BarycentricForm::kOneMinus, 15);
  std::printf("[ MEASURED ] sum with 1 - l0 - l1, inside: %.3f u (f32), %.3f u (f64)\n", single,
              full);
  EXPECT_LE(single * rounding_epsilon<float>(), kOneMinusSumError<float>);
  EXPECT_LE(full * rounding_epsilon<double>(), kOneMinusSumError<double>);
  EXPECT_GT(std::min(single, full), 0.1);
}

TEST(BarycentricsSumTest, DividingByTheVertexAreaHasNoConstantBoundOnNeedles) {
  // The same samples: over the vertex area the sum strays by thousands of u, over the float sum by
  // three at most.
  RandomValues random(16);
  const BarycentricEvaluator& barycentrics = ReferenceBarycentrics(Precision::kFloat32);
  double area = 0;
  double sum = 0;
  for (int n = 0; n < Cases(20000); ++n) {
    const Shape s = HardShape(random, Precision::kFloat32, 1);
    const auto off = [&](BarycentricForm form) {
      const auto l = barycentrics.Barycentrics(form, s.v, s.p);
      if (!(l[0] >= 0 && l[1] >= 0 && l[2] >= 0)) return 0.0;
      return std::fabs(l[0] + l[1] + l[2] - 1) / rounding_epsilon<float>();
    };
    if (exact::EdgeValue(s.v[0], s.v[1], s.v[2]).Sign() == 0) continue;
    const double by_sum = off(BarycentricForm::kSum);
    if (std::isfinite(by_sum)) sum = std::max(sum, by_sum);
    const double by_area = off(BarycentricForm::kVertexArea);
    if (std::isfinite(by_area)) area = std::max(area, by_area);
  }
  EXPECT_GT(area, 1000);
  EXPECT_LE(sum, kNormalizedSumErrorMultiplier<float>);
}

TEST_P(BarycentricsTest, InterpolateByHand) {
  const std::array<Corner, 3> v{Corner{{0, 0}, 1}, Corner{{4, 0}, 4}, Corner{{0, 4}, 2}};
  const std::array<double, 3> z{1, 3, 5};
  // Barycentrics (1/4, 1/4, 1/2).
  EXPECT_EQ(barycentrics().Interpolate(InterpolationForm::kBarycentrics, v, z, {1, 2}), 3.5);
  EXPECT_EQ(barycentrics().Interpolate(InterpolationForm::kDeltas, v, z, {1, 2}), 3.5);
  // (1/4 + 3/16 + 5/4) / (1/4 + 1/16 + 1/4) = (27/16) / (9/16).
  EXPECT_EQ(barycentrics().Interpolate(InterpolationForm::kPerspective, v, z, {1, 2}), 3.0);
  // Camera-space depth is not affine on screen: halfway between w = 1 and 4 it is 8/5, not 5/2.
  const std::array<double, 3> depth{1, 4, 2};
  const double along =
      barycentrics().Interpolate(InterpolationForm::kPerspective, v, depth, {2, 0});
  EXPECT_NEAR(along, 1.6, 1e-6);
  EXPECT_EQ(barycentrics().Interpolate(InterpolationForm::kBarycentrics, v, depth, {2, 0}), 2.5);
}

TEST_P(BarycentricsTest, InterpolatedValuesStayWithinTheirBounds) {
  for (const InterpolationForm form : kInterpolations) {
    Observed observed;
    RandomValues random(17);
    for (int n = 0; n < Cases(2000); ++n) {
      const Shape s = HardShape(random, GetParam(), n % 5);
      std::array<Corner, 3> v;
      std::array<double, 3> z{};
      std::array<double, 3> w{};
      for (std::size_t i = 0; i < 3; ++i) {
        // Both signs of w now and then: the denominator comes near zero.
        w[i] = InPrecision(GetParam(), {random.Uniform(n % 7 == 0 ? -1 : 0.25, 4), 0}).x;
        z[i] = InPrecision(GetParam(), {random.Uniform(-1, 1) + (n % 3 == 0 ? 1e8 : 0), 0}).x;
        v[i] = {s.v[i], w[i]};
      }
      const auto exact = form == InterpolationForm::kPerspective
                             ? exact::InterpolatePerspective(s.v, w, z, s.p)
                             : exact::Interpolate(s.v, z, s.p);
      const double bound = barycentrics().InterpolationErrorBound(form, v, z, s.p);
      if (!exact) {
        EXPECT_TRUE(std::isnan(bound));
        continue;
      }
      const double value = barycentrics().Interpolate(form, v, z, s.p);
      if (!std::isfinite(value)) {
        ASSERT_TRUE(std::isnan(bound));
        continue;
      }
      observed.Add(Rational(value) - *exact, bound);
    }
    observed.Print(name() + "interpolation, form " + std::to_string(static_cast<int>(form)));
    EXPECT_GT(observed.worst, 0.05);
    EXPECT_GT(observed.stated * 2, observed.asked);
  }
}

TEST_P(BarycentricsTest, HeightsBelongToTheVertexAndDistancesToTheOppositeEdge) {
  // Sides 3, 4, 5: area 6, heights 2 * 6 / side.
  const Triangle2 v{Point2{0, 0}, Point2{4, 0}, Point2{0, 3}};
  const auto heights = Heights(GetParam(), v);
  EXPECT_NEAR(heights[0], 2.4, 1e-6);
  EXPECT_EQ(heights[1], 4);
  EXPECT_EQ(heights[2], 3);
  const Point2 p{
      1, 1};  // 1 from the left side, 1 from the upper one, (12 - 3 - 4)/5 = 1 from the third
  const auto by_height = barycentrics().EdgeDistances(WireframeForm::kHeight, v, p);
  for (const double d : by_height) EXPECT_NEAR(d, 1, 1e-6);
  // fwidth is the L1 norm of the gradient: 5 / (3 + 4) for the slanted side, the same for the
  // others.
  const auto by_derivative = barycentrics().EdgeDistances(WireframeForm::kDerivative, v, p);
  EXPECT_NEAR(by_derivative[0], 5.0 / 7, 1e-6);
  EXPECT_EQ(by_derivative[1], 1);
  EXPECT_EQ(by_derivative[2], 1);
  // A published pairing takes the altitude of the wrong vertex: 3 l1 and 4 l2 in place of 4 l1, 3
  // l2.
  const auto l = barycentrics().Barycentrics(BarycentricForm::kVertexArea, v, p);
  EXPECT_NE(l[1] * heights[2], by_height[1]);
  EXPECT_NE(l[2] * heights[1], by_height[2]);
}

TEST_P(BarycentricsTest, EdgeDistancesStayWithinTheirBounds) {
  for (const WireframeForm form : kDistances) {
    Observed observed;
    RandomValues random(18);
    for (int n = 0; n < Cases(2000); ++n) {
      const Shape s = HardShape(random, GetParam(), n % 5);
      const auto lambda = exact::Barycentrics(s.v, s.p);
      if (!lambda) continue;
      const auto d = barycentrics().EdgeDistances(form, s.v, s.p);
      const auto bounds = EdgeDistanceErrorBounds(GetParam(), form, s.v, s.p);
      const int facing = exact::EdgeSign(s.v[0], s.v[1], s.v[2]);
      for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(d[i])) {
          ASSERT_TRUE(std::isnan(bounds[i]));
          continue;
        }
        const Point2 a = s.v[(i + 1) % 3];
        const Point2 b = s.v[(i + 2) % 3];
        const Rational edge = exact::EdgeValue(a, b, s.p) * Rational(facing);
        if (form == WireframeForm::kBarycentric) {
          observed.Add(Rational(d[i]) - (*lambda)[i], bounds[i]);
        } else if (form == WireframeForm::kDerivative) {
          const Rational l1 = (Rational(b.x) - a.x).Abs() + (Rational(b.y) - a.y).Abs();
          observed.Add(Rational(d[i]) - edge / l1, bounds[i]);
        } else {
          // |d - s sqrt(q)| <= bound  <=>  between (|d| - bound)^2 and (|d| + bound)^2, signs
          // alike.
          const auto square = exact::SquaredLineDistance(a, b, s.p);
          ++observed.asked;
          if (std::isnan(bounds[i])) continue;
          ++observed.stated;
          const Rational shown = edge.Sign() < 0 ? -Rational(d[i]) : Rational(d[i]);
          const Rational low = shown - bounds[i];
          const Rational high = shown + bounds[i];
          ASSERT_GE(high.Sign(), 0);
          ASSERT_LE(*square, high * high);
          if (low.Sign() > 0) {
            ASSERT_GE(*square, low * low);
          }
          if (bounds[i] > 0 && GetParam() == Precision::kFloat32) {
            const double root = exact::NearestSquareRoot(*square);
            observed.worst =
                std::max(observed.worst, std::fabs(shown.ToDouble() - root) / bounds[i]);
          }
        }
      }
    }
    observed.Print(name() + "edge distance, form " + std::to_string(static_cast<int>(form)));
    EXPECT_GT(observed.stated * 2, observed.asked);
    if (form != WireframeForm::kHeight || GetParam() == Precision::kFloat32) {
      EXPECT_GT(observed.worst, 0.05);
    }
  }
}

TEST_P(BarycentricsTest, SwappedHeightsAreWrongOnEveryScaleneTriangle) {
  RandomValues random(19);
  int wrong = 0;
  int cases = 0;
  for (int n = 0; n < Cases(2000); ++n) {
    const Shape s = HardShape(random, GetParam(), 0);
    const auto bounds = EdgeDistanceErrorBounds(GetParam(), WireframeForm::kHeight, s.v, s.p);
    const auto h = Heights(GetParam(), s.v);
    const auto l = barycentrics().Barycentrics(BarycentricForm::kVertexArea, s.v, s.p);
    const auto d = barycentrics().EdgeDistances(WireframeForm::kHeight, s.v, s.p);
    if (std::isnan(bounds[1]) || std::fabs(h[1] - h[2]) < 0.01 || std::fabs(l[1]) < 0.01) continue;
    ++cases;
    // The published D_c = H_b l1 and D_b = H_a l2 exchange these two.
    wrong += std::fabs(l[1] * h[2] - d[1]) > 2 * bounds[1] ? 1 : 0;
  }
  EXPECT_GT(cases, Cases(1000));
  EXPECT_EQ(wrong, cases);
}

TEST_P(BarycentricsTest, DegenerateAndNonFiniteTrianglesStateNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const double huge = GetParam() == Precision::kFloat32 ? double{std::numeric_limits<float>::max()}
                                                        : std::numeric_limits<double>::max();
  const std::array<Triangle2, 5> triangles{
      Triangle2{Point2{0, 0}, Point2{2, 2}, Point2{4, 4}},
      Triangle2{Point2{1, 1}, Point2{1, 1}, Point2{1, 1}},
      Triangle2{Point2{nan, 0}, Point2{4, 0}, Point2{0, 4}},
      Triangle2{Point2{inf, 0}, Point2{4, 0}, Point2{0, 4}},
      Triangle2{Point2{-huge, -huge}, Point2{huge, -huge}, Point2{0, huge}}};
  for (const Triangle2& v : triangles) {
    for (const BarycentricForm form : kForms) {
      for (const double bound : barycentrics().BarycentricErrorBounds(form, v, {1, 1})) {
        EXPECT_TRUE(std::isnan(bound));
      }
      EXPECT_TRUE(std::isnan(barycentrics().SumErrorBound(form, v, {1, 1})));
    }
    for (const WireframeForm form : kDistances) {
      for (const double bound : EdgeDistanceErrorBounds(GetParam(), form, v, {1, 1})) {
        EXPECT_TRUE(std::isnan(bound));
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::reference
