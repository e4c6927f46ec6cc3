#include "exact/values.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "core/channel.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "tests/exact/families.h"
#include "tests/exact/naive.h"
#include "tests/exact/naive_values.h"
#include "tests/share.h"

namespace rasterproof::exact {
namespace {

constexpr std::array<Interpolation, 3> kInterpolated{
    Interpolation::kLinear, Interpolation::kPerspective, Interpolation::kInverseW};
constexpr std::array<Point2, 3> kOnScreen{{{0, 0}, {4, 0}, {0, 4}}};

// A triangle of clip space, numbers at its corners and a point of the window.
struct Shown {
  std::array<Vertex, 3> v;
  std::array<double, 3> a{};
  Point2 p;
};

class DrawValues {
 public:
  explicit DrawValues(std::uint64_t seed) : draw_(seed) {}

  Shown Next() {
    Shown shown;
    shown.v = Corners();
    shown.a = Numbers();
    shown.p = Point(shown.v);
    return shown;
  }

 private:
  // 2^exponent times a mantissa of [1, 2), of either sign now and then.
  double Scale(int exponent) {
    const double mantissa = 1 + draw_.Unit();
    return std::ldexp(mantissa, exponent) * (draw_.Below(6) == 0 ? -1 : 1);
  }
  Family AnyFamily() { return static_cast<Family>(draw_.Below(kFamilies)); }

  double AnyW(int kind) {
    switch (kind) {
      case 0:
        return 1;
      case 1:
        return Scale(draw_.Below(61) - 30);  // ratios to 2^60
      case 2:
        return draw_.Below(2) == 0 ? 0 : Scale(-40 - draw_.Below(20));
      case 3:
        return std::ldexp(draw_.Sign(), draw_.Below(5) - 2);
      default:
        return draw_.Coordinate(Family::kSignedZeros);
    }
  }

  std::array<Vertex, 3> Corners() {
    std::array<Vertex, 3> v;
    // All numbers of any size, as the families of clip space have them; few, for they are long.
    if (draw_.Below(16) == 0) {
      const Family family = AnyFamily();
      for (Vertex& at : v) {
        at = {draw_.Coordinate(family), draw_.Coordinate(family), 0, draw_.Coordinate(family)};
      }
      return v;
    }
    const int kind = draw_.Below(5);
    const bool sliver = draw_.Below(3) == 0;
    const double t = draw_.Unit();
    for (std::size_t i = 0; i < 3; ++i) {
      const Family family = draw_.Below(2) == 0 ? Family::kUniform : Family::kHalfPixels;
      const double w = AnyW(kind);
      const double scale = w != 0 ? w : 1;
      const double x = draw_.Coordinate(family) * scale;
      const double y = draw_.Coordinate(family) * scale;
      v[i] = {x, y, 0, w};
    }
    if (draw_.Below(24) == 0) {
      v[2] = {2 * v[1].x, 2 * v[1].y, 0, 2 * v[1].w};  // no area
    } else if (sliver) {
      const auto between = [&](double from, double to) {
        return MoveByUlps(from * (1 - t) + to * t, draw_.Below(5) - 2);
      };
      v[2] = {between(v[0].x, v[1].x), between(v[0].y, v[1].y), 0, between(v[0].w, v[1].w)};
    }
    return v;
  }

  std::array<double, 3> Numbers() {
    const double base = Scale(draw_.Below(40) - 20);
    switch (draw_.Below(8)) {
      case 0:
        return {base, base, base};
      case 1:
        return {base, MoveByUlps(base, draw_.Below(5) - 2), MoveByUlps(base, draw_.Below(3) - 1)};
      case 2:
        return {1e6 + 1, -1e6, 1e6 - 1};
      case 3:
        return {1, 0, 0};
      case 4: {
        const Family family = AnyFamily();
        return {draw_.Coordinate(family), draw_.Coordinate(family), draw_.Coordinate(family)};
      }
      default:
        return {base, Scale(draw_.Below(40) - 20), draw_.Unit()};
    }
  }

  Point2 Point(const std::array<Vertex, 3>& v) {
    const auto i = static_cast<std::size_t>(draw_.Below(3));
    const auto placed = [&](std::size_t k) {
      const Point2 at{v[k].x / v[k].w, v[k].y / v[k].w};
      return std::isfinite(at.x) && std::isfinite(at.y) ? at : Point2{0.5, 0.5};
    };
    switch (draw_.Below(6)) {
      case 0:
        return placed(i);  // exactly a corner where w is a power of two
      case 1: {
        const Point2 a = placed(i);
        const Point2 b = placed((i + 1) % 3);
        return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
      }
      case 2:
        return {Scale(20 + draw_.Below(40)), Scale(20 + draw_.Below(40))};
      case 3: {
        const Family family = AnyFamily();
        return {draw_.Coordinate(family), draw_.Coordinate(family)};
      }
      default:
        return {0.5 + draw_.Below(16), 0.5 + draw_.Below(16)};
    }
  }

  Draw draw_;
};

TEST(Values, EqualThoseOfPlanesByElimination) {
  // With RASTERPROOF_MORE (scripts/test_more) a million values and derivatives.
  const int wanted = RunsMore() ? 1'000'000 : Cases(6000);
  DrawValues draw(31);
  int compared = 0;
  int nothing = 0;
  int on_horizon = 0;
  int behind = 0;
  while (compared < wanted) {
    const Shown shown = draw.Next();
    const NaiveRows rows = NaiveRowsOf(shown.v);
    const std::array<mpq_class, 3> a{mpq_class(shown.a[0]), mpq_class(shown.a[1]),
                                     mpq_class(shown.a[2])};
    const Interpolant interpolant(ClipTriangle(shown.v), shown.p);
    for (const Interpolation interpolation : kInterpolated) {
      const auto exact = interpolant.Derivatives(interpolation, ToAttribute(shown.a));
      const auto naive = NaiveValueAt(rows, interpolation, a, shown.p);
      ASSERT_EQ(exact.has_value(), naive.has_value()) << compared;
      if (!exact) {
        ++nothing;
        if (interpolation == Interpolation::kPerspective &&
            interpolant.Value(Interpolation::kLinear, Ones())) {
          ++on_horizon;
        }
        continue;
      }
      ASSERT_TRUE(Equal(*exact, *naive)) << compared;
      ASSERT_EQ(*interpolant.Value(interpolation, ToAttribute(shown.a)), exact->value);
      compared += 3;
      if (shown.v[0].w <= 0 || shown.v[1].w <= 0 || shown.v[2].w <= 0) behind += 3;
    }
  }
  std::printf("%d values and derivatives, %d with a w <= 0; %d times nothing, %d on a horizon\n",
              compared, behind, nothing, on_horizon);
  EXPECT_GT(behind, compared / 5);
  EXPECT_GT(nothing, compared / 100);
  EXPECT_TRUE(on_horizon > 0 || kOneCaseIn > 1);
}

TEST(Values, AreThoseComputedByHand) {
  // Camera depth 1 and 4 at the ends of an edge of the screen. Along it 1/w = 1 - 3x/16.
  const Interpolant middle(WindowTriangle(kOnScreen, {1, 4, 1}), {2, 0});
  const Attribute depth{1, 4, 3};
  const auto perspective = middle.Derivatives(Interpolation::kPerspective, depth);
  EXPECT_EQ(perspective->value.ToString(), "8/5");
  EXPECT_EQ(perspective->dx.ToString(), "12/25") << "3/16 (8/5)^2";
  EXPECT_EQ(perspective->dy.ToString(), "4/5") << "(3 - 1)/4 / (5/8)";
  const auto linear = middle.Derivatives(Interpolation::kLinear, depth);
  EXPECT_EQ(linear->value.ToString(), "5/2");
  EXPECT_EQ(linear->dx.ToString(), "3/4");
  EXPECT_EQ(linear->dy.ToString(), "1/2");
  const auto inverse_w = middle.Derivatives(Interpolation::kInverseW, Ones());
  EXPECT_EQ(inverse_w->value.ToString(), "5/8");
  EXPECT_EQ(inverse_w->dx.ToString(), "-3/16");
  EXPECT_EQ(inverse_w->dy.ToString(), "0");
  const auto weights = middle.Weights(Interpolation::kPerspective);
  EXPECT_EQ((*weights)[0].ToString(), "4/5");
  EXPECT_EQ((*weights)[1].ToString(), "1/5");
  EXPECT_EQ((*weights)[2].ToString(), "0");
}

TEST(Values, AreDefinedWhereACornerLiesAtInfinityOrBehindTheEye) {
  const Attribute second{0, 1, 0};
  // With (p, 1) = sum nu_i V_i: nu = (1 - y, x, y), their sum 1 + x.
  const Interpolant infinite(ClipTriangle({{{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 1}}}), {3, 0.25});
  const auto value = infinite.Derivatives(Interpolation::kPerspective, second);
  EXPECT_EQ(value->value.ToString(), "3/4");
  EXPECT_EQ(value->dx.ToString(), "1/16");
  EXPECT_EQ(infinite.Value(Interpolation::kInverseW, Ones())->ToString(), "4");
  EXPECT_EQ(infinite.Value(Interpolation::kLinear, {8, 1, 4})->ToString(), "7")
      << "on the screen a corner at infinity weighs nothing";
  // nu = (1 - x - y, -x, y), their sum 1 - 2x.
  const auto behind = [](Point2 p) {
    return Interpolant(ClipTriangle({{{0, 0, 0, 1}, {-1, 0, 0, -1}, {0, 1, 0, 1}}}), p);
  };
  const auto before = behind({0.25, 0}).Derivatives(Interpolation::kPerspective, second);
  EXPECT_EQ(before->value.ToString(), "-1/2");
  EXPECT_EQ(before->dx.ToString(), "-4");
  EXPECT_FALSE(behind({0.5, 0}).Value(Interpolation::kPerspective, second)) << "the horizon";
  EXPECT_EQ(behind({0.5, 0}).Value(Interpolation::kLinear, second)->ToString(), "1/2");
  EXPECT_EQ(behind({0.5, 0}).Value(Interpolation::kInverseW, Ones())->ToString(), "0");
}

TEST(Values, AreNothingForDegenerateTrianglesAndFlatNumbers) {
  const auto all_nothing = [](const HomogeneousTriangle& v) {
    const Interpolant interpolant(v, {0.5, 0.25});
    for (const Interpolation interpolation : kInterpolated) {
      EXPECT_FALSE(interpolant.Weights(interpolation));
      EXPECT_FALSE(interpolant.Value(interpolation, {1, 2, 3}));
      EXPECT_FALSE(interpolant.Derivatives(interpolation, {1, 2, 3}));
      EXPECT_FALSE(interpolant.Conditions(interpolation, {1, 2, 3}));
    }
  };
  all_nothing(WindowTriangle({{{0, 0}, {1, 1}, {3, 3}}}));
  all_nothing(WindowTriangle({{{0, 0}, {1, 0}, {1, 0}}}, {1, 2, 3}));
  all_nothing(WindowTriangle(kOnScreen, {1, 0, 1}));
  all_nothing(ClipTriangle({{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}}));
  EXPECT_FALSE(
      Interpolant(WindowTriangle(kOnScreen), {1, 1}).Value(Interpolation::kFlat, {1, 2, 3}));
}

TEST(Values, AreThoseOfTheCornerAtACorner) {
  Draw draw(32);
  for (int k = 0; k < Cases(300); ++k) {
    const auto v = draw.EdgeAndPoint(static_cast<Family>(k % kFamilies));
    const std::array<double, 3> w{std::ldexp(draw.Sign(), draw.Below(60) - 30), draw.Unit() + 1,
                                  draw.Sign()};
    const Attribute a{draw.Coordinate(Family::kFloat32Bits), draw.Coordinate(Family::kSubnormal),
                      draw.Unit()};
    for (std::size_t i = 0; i < 3; ++i) {
      const Interpolant at_corner(WindowTriangle(v, w), v[i]);
      if (!at_corner.Weights(Interpolation::kLinear)) continue;
      ASSERT_EQ(*at_corner.Value(Interpolation::kPerspective, a), a[i]);
      ASSERT_EQ(*at_corner.Value(Interpolation::kLinear, a), a[i]);
      ASSERT_EQ(*at_corner.Value(Interpolation::kInverseW, Ones()) * w[i], Rational(1));
    }
  }
}

TEST(Values, StayConstantWhereTheyAreEqual) {
  DrawValues draw(33);
  for (int k = 0; k < Cases(500); ++k) {
    const Shown shown = draw.Next();
    const Interpolant interpolant(ClipTriangle(shown.v), shown.p);
    const Rational a = shown.a[0];
    for (const Interpolation interpolation :
         {Interpolation::kLinear, Interpolation::kPerspective}) {
      const auto constant = interpolant.Derivatives(interpolation, {a, a, a});
      if (!constant) continue;
      ASSERT_EQ(constant->value, a);
      ASSERT_EQ(constant->dx, Rational(0));
      ASSERT_EQ(constant->dy, Rational(0));
    }
  }
}

TEST(Values, HaveWeightsThatSumToOneAndPlaceTheSample) {
  DrawValues draw(34);
  for (int k = 0; k < Cases(500); ++k) {
    const Shown shown = draw.Next();
    const HomogeneousTriangle v = ClipTriangle(shown.v);
    const Interpolant interpolant(v, shown.p);
    for (const Interpolation interpolation : kInterpolated) {
      const auto weights = interpolant.Weights(interpolation);
      if (!weights) continue;
      const auto& [first, second, third] = *weights;
      const auto sum = [&](const Rational& a, const Rational& b, const Rational& c) {
        return first * a + second * b + third * c;
      };
      ASSERT_EQ(*interpolant.Value(interpolation, {1, 0, 0}), first);
      ASSERT_EQ(*interpolant.Value(interpolation, {0, 0, 1}), third);
      ASSERT_EQ(*interpolant.Value(interpolation, ToAttribute(shown.a)),
                sum(shown.a[0], shown.a[1], shown.a[2]));
      if (interpolation == Interpolation::kLinear) {
        ASSERT_EQ(sum(1, 1, 1), Rational(1));
        if (v[0].w.Sign() == 0 || v[1].w.Sign() == 0 || v[2].w.Sign() == 0) continue;
        ASSERT_EQ(sum(v[0].x / v[0].w, v[1].x / v[1].w, v[2].x / v[2].w), Rational(shown.p.x));
        ASSERT_EQ(sum(v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w), Rational(shown.p.y));
        continue;
      }
      // In space: the weights place the point of the ray through p.
      const Rational w = sum(v[0].w, v[1].w, v[2].w);
      ASSERT_EQ(sum(v[0].x, v[1].x, v[2].x), w * shown.p.x);
      ASSERT_EQ(sum(v[0].y, v[1].y, v[2].y), w * shown.p.y);
      const bool perspective = interpolation == Interpolation::kPerspective;
      ASSERT_EQ(perspective ? sum(1, 1, 1) : w, Rational(1));
    }
  }
}

mpq_class ToNaive(const Rational& x) { return mpq_class(x.ToString()); }

// Value and derivatives by the formulas, one of the 18 products off by the relative unit `off`.
NaiveValue WithAProductOff(const Shown& shown, Interpolation interpolation, int product,
                           const mpq_class& off) {
  const NaiveRows rows = NaiveRowsOf(shown.v);
  int counted = 0;
  const auto times = [&](const mpq_class& a, const mpq_class& b) {
    const bool is_off = counted++ == product;
    return is_off ? mpq_class(a * b * (1 + off)) : mpq_class(a * b);
  };
  NaiveValue n;
  NaiveValue d;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = rows[(i + 1) % 3];
    const auto& b = rows[(i + 2) % 3];
    const mpq_class dx = times(a[1], b[2]) - times(a[2], b[1]);
    const mpq_class dy = times(a[2], b[0]) - times(a[0], b[2]);
    const mpq_class beta = dx * shown.p.x + dy * shown.p.y + times(a[0], b[1]) - times(a[1], b[0]);
    const mpq_class e = interpolation == Interpolation::kPerspective ? mpq_class(1) : rows[i][2];
    mpq_class c = shown.a[i];
    if (interpolation == Interpolation::kLinear) c *= rows[i][2];
    n = {n.value + beta * c, n.dx + dx * c, n.dy + dy * c};
    d = {d.value + beta * e, d.dx + dx * e, d.dy + dy * e};
  }
  const mpq_class value = n.value / d.value;
  return {value, (n.dx - value * d.dx) / d.value, (n.dy - value * d.dy) / d.value};
}

// How far each number moves, to first order, when all products are off by one relative unit, each
// in its worst direction.
NaiveValue FurthestMove(const Shown& shown, Interpolation interpolation) {
  const mpq_class off = NaiveTwoTo(-3000);
  const NaiveValue exact = WithAProductOff(shown, interpolation, 0, 0);
  NaiveValue moved;
  for (int product = 0; product < 18; ++product) {
    const NaiveValue at = WithAProductOff(shown, interpolation, product, off);
    moved.value += abs(at.value - exact.value) / off;
    moved.dx += abs(at.dx - exact.dx) / off;
    moved.dy += abs(at.dy - exact.dy) / off;
  }
  return moved;
}

// moved / condition, once it is found to be at most one but for terms of second order.
double ShareOf(const mpq_class& moved, const Rational& condition) {
  const mpq_class most = ToNaive(condition);
  EXPECT_TRUE(moved <= most * (1 + NaiveTwoTo(-100)));
  return most == 0 ? 0 : mpq_class(moved / most).get_d();
}

TEST(ValueConditions, BoundHowFarAValueMovesWhenItsProductsAreOff) {
  DrawValues draw(35);
  double closest = 0;
  double closest_derivative = 0;
  for (int k = 0; k < (RunsMore() ? 2000 : 60); ++k) {
    const Shown shown = draw.Next();
    const Interpolant interpolant(ClipTriangle(shown.v), shown.p);
    for (const Interpolation interpolation : kInterpolated) {
      const auto condition = interpolant.Conditions(interpolation, ToAttribute(shown.a));
      if (!condition) continue;
      const NaiveValue moved = FurthestMove(shown, interpolation);
      const Rational value = *interpolant.Value(interpolation, ToAttribute(shown.a));
      ASSERT_GE(condition->value, value.Abs() * 2);
      closest = std::max(closest, ShareOf(moved.value, condition->value));
      closest_derivative = std::max(
          {closest_derivative, ShareOf(moved.dx, condition->dx), ShareOf(moved.dy, condition->dy)});
      ASSERT_FALSE(HasFailure()) << k;
    }
  }
  std::printf("moved by up to %.3f of the condition, derivatives by %.3f\n", closest,
              closest_derivative);
  EXPECT_GT(closest, 0.9) << "the bound is attained";
  EXPECT_GT(closest_derivative, 0.5);
}

TEST(ValueConditions, AreThoseComputedByHand) {
  // V = (0, 0, 1), (16, 0, 4), (0, 4, 1), p = (2, 0): M = (4*4*2 + 64, 4*2, 0) = (96, 8, 0),
  // S = 32 + 8 = 40 and D = 64. With a = (1, 4, 3) the value is 8/5.
  const Interpolant middle(WindowTriangle(kOnScreen, {1, 4, 1}), {2, 0});
  const Attribute depth{1, 4, 3};
  EXPECT_EQ(middle.Conditions(Interpolation::kPerspective, depth)->value,
            (Rational(96) * 13 / 5 + Rational(8) * 28 / 5) / 40);
  EXPECT_EQ(middle.Conditions(Interpolation::kLinear, depth)->value,
            (Rational(96) * 7 / 2 + Rational(8) * 4 * 13 / 2) / 64);
  EXPECT_EQ(middle.Conditions(Interpolation::kInverseW, Ones())->value,
            Rational(104) / 64 + Rational(5) / 8 * (96 + 8 * 4) / 64);
}

}  // namespace
}  // namespace rasterproof::exact
