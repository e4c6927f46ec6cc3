// Every method of values against the oracle's rationals: within its stated bound, as near to it as
// a search comes, and with the promises that its row states.
#include "reference/value_methods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/channel.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/value_rule.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "exact/values.h"
#include "tests/climb.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::HomogeneousPoint;
using exact::HomogeneousTriangle;
using exact::Rational;
using RationalPoint = std::array<Rational, 2>;

template <class T>
constexpr bool kIsFloat = sizeof(T) == sizeof(float);
template <class T>
constexpr Precision kPrecisionOf = kIsFloat<T> ? Precision::kFloat32 : Precision::kFloat64;

template <class T>
T ShownBy(const ValueMethod& method, const ValueTask<T>& task) {
  if constexpr (kIsFloat<T>) {
    return method.float32(task);
  } else {
    return method.float64(task);
  }
}

template <class T>
HomogeneousTriangle CornersOf(const ValueTask<T>& task) {
  const auto corner = [&](std::size_t i) {
    const ValueCorner<T>& v = task.v[i];
    return HomogeneousPoint{Rational(v.x), Rational(v.y), Rational(v.w)};
  };
  return {corner(0), corner(1), corner(2)};
}

template <class T>
exact::Attribute NumbersOf(const ValueTask<T>& task) {
  return exact::ToAttribute({task.a[0], task.a[1], task.a[2]});
}

/// A value with its condition, and the denominator's relative one.
struct Truth {
  Rational value;
  Rational condition;
  Rational denominator;
};

HomogeneousPoint MovedBy(const HomogeneousPoint& v, const RationalPoint& q) {
  return {v.x - q[0] * v.w, v.y - q[1] * v.w, v.w};
}

/// The magnitudes of the products in beta_i, counted from q.
Rational MagnitudesAbout(const RationalPoint& q, const HomogeneousTriangle& v, std::size_t i,
                         const RationalPoint& p) {
  const HomogeneousPoint j = MovedBy(v[(i + 1) % 3], q);
  const HomogeneousPoint k = MovedBy(v[(i + 2) % 3], q);
  return ((j.y * k.w).Abs() + (j.w * k.y).Abs()) * (p[0] - q[0]).Abs() +
         ((j.w * k.x).Abs() + (j.x * k.w).Abs()) * (p[1] - q[1]).Abs() + (j.x * k.y).Abs() +
         (j.y * k.x).Abs();
}

/// At (x, y) of the task, and nothing on the horizon or without an area. In the window corners are
/// their own places.
template <class T>
std::optional<Truth> TruthAt(const ValueTask<T>& task, double x, ConditionAbout about) {
  const HomogeneousTriangle v = CornersOf(task);
  const double y = task.y;
  const exact::Interpolant interpolant(v, Point2{x, y});
  const exact::Attribute a = NumbersOf(task);
  const auto weights = interpolant.Weights(Interpolation::kInverseW);  // beta_i / D
  const auto value = interpolant.Value(Interpolation::kPerspective, a);
  if (!weights || !value) return std::nullopt;
  const Rational determinant = v[0].x * (v[1].y * v[2].w - v[1].w * v[2].y) -
                               v[0].y * (v[1].x * v[2].w - v[1].w * v[2].x) +
                               v[0].w * (v[1].x * v[2].y - v[1].y * v[2].x);
  const Rational sum = ((*weights)[0] + (*weights)[1] + (*weights)[2]) * determinant;
  const RationalPoint p{x, y};
  Truth truth{*value, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousPoint& from = v[about == ConditionAbout::kEdgeStart ? (i + 1) % 3 : 0];
    RationalPoint q;
    if (about != ConditionAbout::kOrigin) q = {from.x, from.y};
    const Rational share = MagnitudesAbout(q, v, i, p) / sum.Abs();
    truth.condition += share * (a[i].Abs() + value->Abs());
    truth.denominator += share;
  }
  return truth;
}

/// Of the number that the row is about.
template <class T>
std::optional<Truth> TruthOf(const ValueMethod& method, const ValueTask<T>& task) {
  const double x = task.x;
  const auto here = TruthAt(task, x, method.about);
  if (!here || method.target == ValueTarget::kValue) return here;
  const bool is_stepped = method.target == ValueTarget::kAfterSteps;
  const auto there = TruthAt(task, is_stepped ? x + task.steps : x + 1, method.about);
  if (!there) return std::nullopt;
  const Rational denominator = std::max(here->denominator, there->denominator);
  if (is_stepped) {
    return Truth{there->value, std::max(here->condition, there->condition), denominator};
  }
  return Truth{there->value - here->value, here->condition + there->condition, denominator};
}

/// The stated error as it is judged, grown as props/judging/values does; nothing where it is not.
template <class T>
std::optional<ValueError> Judged(const ValueMethod& method, const ValueTask<T>& task,
                                 const Truth& truth) {
  ValueError error{.ulps = method.ulps, .absolute = 0, .conditions = 0};
  error.conditions = method.ConditionsOf(kIsFloat<T>, task.steps);
  const double share = error.conditions * rounding_epsilon<T>() * truth.denominator.ToDoubleUp();
  if (!(share < 0.5)) return std::nullopt;
  error.conditions /= 1 - share;
  return error;
}

/// error / bound. The verdict is exact::IsWithin's; `scale` times the bound is what it is held to.
template <class T>
double ShareOfBound(const ValueMethod& method, const ValueTask<T>& task, double scale = 1) {
  const auto truth = TruthOf(method, task);
  if (!truth) return 0;
  auto error = Judged(method, task, *truth);
  if (!error) return 0;
  const double shown = ShownBy(method, task);
  error->ulps *= scale;
  error->conditions *= scale;
  const bool holds =
      exact::IsWithin(shown, truth->value, truth->condition, *error, kPrecisionOf<T>);
  if (!std::isfinite(shown)) {
    ADD_FAILURE() << method.name << ": not finite";
    return 2;
  }
  const Rational allowed =
      Rational(error->ulps) * exact::Ulp(truth->value, kPrecisionOf<T>) +
      Rational(error->conditions) * double{rounding_epsilon<T>()} * truth->condition;
  const Rational off = (truth->value - shown).Abs();
  EXPECT_EQ(holds, off <= allowed) << method.name;
  return off.Sign() == 0 ? 0 : (off / allowed).ToDouble();
}

/// Numbers on a grid that steps of one keep.
template <class T>
T OnSteps(double x) {
  return static_cast<T>(std::nearbyint(x * 16) / 16);
}

enum class Shape : std::uint8_t {
  kScreen,
  kNeedle,
  kFar,         ///< 2^12 to 2^18 from the origin
  kRatios,      ///< of w, up to 2^40
  kEqual,       ///< numbers at the corners
  kCancelling,  ///< 10^6 +- 1
  kAtAVertex,
  kCount
};

constexpr std::array<Shape, 7> kShapes{Shape::kScreen,   Shape::kNeedle, Shape::kFar,
                                       Shape::kRatios,   Shape::kEqual,  Shape::kCancelling,
                                       Shape::kAtAVertex};

template <class T>
void MoveIntoTheTriangle(RandomValues& random, ValueTask<T>& task) {
  const double l1 = random.Uniform(0, 1);
  const double l2 = random.Uniform(0, 1 - l1);
  const auto at = [&](T ValueCorner<T>::* axis) {
    const auto place = [&](std::size_t i) { return double{task.v[i].*axis} / double{task.v[i].w}; };
    return place(0) + l1 * (place(1) - place(0)) + l2 * (place(2) - place(0));
  };
  task.x = static_cast<T>(at(&ValueCorner<T>::x));
  task.y = static_cast<T>(at(&ValueCorner<T>::y));
}

template <class T>
void SetPlaces(RandomValues& random, Shape shape, ValueTask<T>& task) {
  const double far = shape == Shape::kFar ? std::ldexp(1, random.Integer(12, 18)) : 0;
  for (ValueCorner<T>& v : task.v) {
    v.x = static_cast<T>(far + random.Uniform(-100, 1100));
    v.y = static_cast<T>(far + random.Uniform(-100, 1100));
  }
  if (shape != Shape::kNeedle) return;
  const double along = random.Uniform(0, 1);
  const double aside = std::ldexp(1, random.Integer(-12, 0));
  const auto needle = [&](T ValueCorner<T>::* axis) {
    const double from = task.v[0].*axis;
    return static_cast<T>(from + along * (task.v[1].*axis - from) + aside * random.Uniform(-1, 1));
  };
  task.v[2].x = needle(&ValueCorner<T>::x);
  task.v[2].y = needle(&ValueCorner<T>::y);
}

template <class T>
ValueTask<T> Drawn(RandomValues& random, const ValueMethod& method, Shape shape) {
  ValueTask<T> task;
  SetPlaces(random, shape, task);
  for (T& a : task.a) {
    a = static_cast<T>(shape == Shape::kCancelling ? 1e6 + random.Uniform(-1, 1)
                                                   : random.Uniform(-2, 2));
  }
  if (shape == Shape::kEqual) task.a = {task.a[0], task.a[0], task.a[0]};
  if (method.space == ValueSpace::kClip && shape != Shape::kAtAVertex) {
    const int ratio = shape == Shape::kRatios ? 20 : 2;
    for (ValueCorner<T>& v : task.v) {
      v.w = std::fabs(random.LogUniform<T>(-ratio, ratio));
      v.x *= v.w;
      v.y *= v.w;
    }
  }
  MoveIntoTheTriangle(random, task);
  if (shape == Shape::kAtAVertex) {
    const ValueCorner<T>& v = task.v[static_cast<std::size_t>(random.Integer(0, 2))];
    task.x = v.x;
    task.y = v.y;
  }
  if (method.target != ValueTarget::kValue) task.x = OnSteps<T>(task.x);
  if (method.target == ValueTarget::kAfterSteps) task.steps = random.Integer(0, 600);
  return task;
}

template <class T>
void ExpectWithinTheBound(const ValueMethod& method, int cases) {
  RandomValues random(81);
  int judged = 0;
  for (int n = 0; n < cases; ++n) {
    const Shape shape = kShapes[static_cast<std::size_t>(n) % kShapes.size()];
    const double share = ShareOfBound(method, Drawn<T>(random, method, shape));
    judged += share > 0 ? 1 : 0;
    ASSERT_LE(share, 1) << method.name << ", shape " << static_cast<int>(shape) << ", case " << n;
  }
  EXPECT_GT(judged, cases / 4) << method.name;
}

TEST(ValueMethods, StayWithinTheirBoundsOnHardTriangles) {
  for (const ValueMethod& method : ValueMethods()) {
    ExpectWithinTheBound<float>(method, Cases(420));
    ExpectWithinTheBound<double>(method, Cases(140));
  }
}

TEST(ValueMethods, AreJudgedByTheOraclesOwnCondition) {
  RandomValues random(82);
  const ValueMethod& method = ValueMethods().back();
  for (int n = 0; n < Cases(200); ++n) {
    const auto task = Drawn<double>(random, method, kShapes[static_cast<std::size_t>(n) % 7]);
    const auto truth = TruthAt(task, task.x, ConditionAbout::kOrigin);
    const exact::Attribute a = NumbersOf(task);
    const exact::Interpolant interpolant(CornersOf(task), {task.x, task.y});
    const auto condition = interpolant.Conditions(Interpolation::kPerspective, a);
    const auto ones = interpolant.Conditions(Interpolation::kPerspective, exact::Ones());
    ASSERT_EQ(truth.has_value(), condition.has_value());
    if (!truth) continue;
    EXPECT_EQ(truth->condition, condition->value);
    EXPECT_EQ(truth->denominator * 2, ones->value);
  }
}

/// x, y, w and a of the corners, and the point.
template <class T>
ValueTask<T> TaskOf(const ValueMethod& method, const std::array<double, 14>& c) {
  ValueTask<T> task;
  for (std::size_t i = 0; i < 3; ++i) {
    const double w = method.space == ValueSpace::kClip ? c[9 + i] : 1;
    task.v[i] = {static_cast<T>(c[i]), static_cast<T>(c[3 + i]), static_cast<T>(w)};
    task.a[i] = static_cast<T>(c[6 + i]);
  }
  task.x = static_cast<T>(c[12]);
  task.y = static_cast<T>(c[13]);
  if (method.target != ValueTarget::kValue) task.x = OnSteps<T>(c[12]);
  if (method.target == ValueTarget::kAfterSteps) task.steps = 64;
  return task;
}

template <class T>
double LargestShare(const ValueMethod& method, int evaluations) {
  const auto draw = [](RandomValues& random) { return random.LogUniform<double>(-2, 2); };
  return Largest<14>({.seed = 83, .evaluations = evaluations}, draw,
                     [&](const auto& c) { return ShareOfBound(method, TaskOf<T>(method, c)); });
}

/// What the search has to reach: lowered to this, the bound is seen to fail.
double FloorOf(const ValueMethod& method) { return method.ulps > 0 ? 0.99 : 0.25; }

std::string BoundText(const ValueMethod& method, bool is_float) {
  std::array<char, 64> text{};
  const double conditions = method.ConditionsOf(is_float, 0);
  if (method.ulps > 0) {
    std::snprintf(text.data(), text.size(), "%g ulp", method.ulps);
  } else if (method.conditions_a_step > 0) {
    std::snprintf(text.data(), text.size(), "%.5g + %.3g n", conditions, method.conditions_a_step);
  } else {
    std::snprintf(text.data(), text.size(), "%.5g", conditions);
  }
  return text.data();
}

TEST(ValueMethods, NoSearchExceedsTheirBounds) {
  std::printf("| method | bound, float32 | bound, float64 | float32 | float64 |\n");
  for (const ValueMethod& method : ValueMethods()) {
    const int evaluations = Cases(RunsMore() ? 20000 : 2000);
    const double in_float = LargestShare<float>(method, evaluations);
    const double in_double = LargestShare<double>(method, evaluations / 4);
    std::printf("| `%s` | %s | %s | %.3f | %.3f |\n", std::string(method.name).c_str(),
                BoundText(method, true).c_str(), BoundText(method, false).c_str(), in_float,
                in_double);
    EXPECT_LE(std::max(in_float, in_double), 1) << method.name;
    EXPECT_GT(in_float, FloorOf(method) / (kOneCaseIn > 1 ? 8 : 1)) << method.name;
  }
}

/// How many of the drawn cases break each promise.
struct Broken {
  int equal = 0;
  int vertices = 0;
  int hull = 0;
};

template <class T>
bool LiesInTheTriangle(const ValueTask<T>& task) {
  const auto weights =
      exact::Interpolant(CornersOf(task), {task.x, task.y}).Weights(Interpolation::kPerspective);
  return weights && std::ranges::all_of(*weights, [](const Rational& l) { return l.Sign() >= 0; });
}

template <class T>
void Count(const ValueMethod& method, const ValueTask<T>& task, Shape shape, Broken& broken) {
  const auto truth = TruthAt(task, task.x, method.about);
  if (!truth || !Judged(method, task, *truth)) return;
  ValueTask<T> here = task;
  here.steps = shape == Shape::kEqual ? task.steps : 0;
  const T shown = ShownBy(method, here);
  if (shape == Shape::kEqual && shown != task.a[0]) ++broken.equal;
  if (shape == Shape::kAtAVertex) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_here = task.x == task.v[i].x && task.y == task.v[i].y;
      if (is_here && shown != task.a[i]) ++broken.vertices;
    }
  }
  const auto [least, most] = std::ranges::minmax(task.a);
  if (!(shown >= least && shown <= most) && here.steps == 0 && LiesInTheTriangle(task)) {
    ++broken.hull;
  }
}

template <class T>
void ExpectPromises(const ValueMethod& method, int cases) {
  RandomValues random(84);
  Broken broken;
  for (int n = 0; n < cases; ++n) {
    const Shape shape = kShapes[static_cast<std::size_t>(n) % kShapes.size()];
    const auto task = Drawn<T>(random, method, shape);
    Count(method, task, shape, broken);
  }
  EXPECT_EQ(method.equal_stay_equal, broken.equal == 0) << method.name;
  EXPECT_EQ(method.exact_at_vertices, broken.vertices == 0) << method.name;
  EXPECT_EQ(method.stays_in_hull, broken.hull == 0) << method.name;
}

TEST(ValueMethods, KeepThePromisesOfTheirRowsAndBreakTheOthers) {
  for (const ValueMethod& method : ValueMethods()) {
    if (method.target == ValueTarget::kDifference) continue;
    ExpectPromises<float>(method, Cases(2100) * (kOneCaseIn > 1 ? 4 : 1));
  }
}

TEST(ValueMethods, CorrectlyRoundedIsTheNearestNumberTiesToEven) {
  RandomValues random(85);
  const auto expect = [&]<class T>(const ValueTask<T>& task) {
    const auto truth = TruthAt(task, task.x, ConditionAbout::kOrigin);
    if (!truth) return;
    const T shown = CorrectlyRoundedValue(task);
    if constexpr (kIsFloat<T>) {
      EXPECT_EQ(shown, truth->value.ToFloat());
    } else {
      EXPECT_EQ(shown, truth->value.ToDouble());
    }
  };
  const ValueMethod& method = ValueMethods().back();
  for (int n = 0; n < Cases(600); ++n) {
    const Shape shape = kShapes[static_cast<std::size_t>(n) % kShapes.size()];
    expect(Drawn<float>(random, method, shape));
    expect(Drawn<double>(random, method, shape));
  }
  // Half way between 1 and its upper neighbour, and between that and the next.
  ValueTask<float> tie{.v = {{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}}, .a = {}, .x = 1, .y = 0};
  for (const float a : {1.0F, 1 + 0x1p-23F, 1 + 0x1p-22F}) {
    tie.a = {a, a + 0x1p-23F, 0};
    expect(tie);
    tie.a = {-a, -a - 0x1p-23F, 0};
    expect(tie);
  }
  ValueTask<double> flat;
  EXPECT_TRUE(std::isnan(CorrectlyRoundedValue(flat)));
}

TEST(ValueMethods, NoConditionAboutTheOriginBoundsEdgesFromTheirStart) {
  // A corner far to the upper left, one beside the origin and a sample there: |a.x a.y| is in the
  // edge value's rounding, and in no product about the origin.
  RandomValues random(86);
  ValueMethod method = ValueMethods().front();
  method.about = ConditionAbout::kOrigin;
  double worst = 0;
  for (int n = 0; n < 400; ++n) {
    ValueTask<float> task;
    const auto near = [&](double x) { return static_cast<float>(x + random.Uniform(-0.2, 0.2)); };
    task.v = {
        {{near(-1023.7), near(-1023.7), 1}, {near(0), near(0), 1}, {near(900), near(-900), 1}}};
    task.a = {0, 0, 1};
    task.x = 0.5F;
    task.y = 0.5F;
    worst = std::max(worst, ShareOfBound(method, task) * kEdgeProductsConditions);
  }
  std::printf("[ MEASURED ] edge values from their start: %.0f conditions about the origin\n",
              worst);
  EXPECT_GT(worst, kUsualConditions);
}

}  // namespace
}  // namespace rasterproof::reference
