// Every method of values against the oracle's rationals: within its stated bound, as near to it as
// a search comes, and with the promises that its row states.
#include "reference/value_methods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/channel.h"
#include "core/value_rule.h"
#include "exact/rational.h"
#include "exact/values.h"
#include "fmt/format.h"
#include "reference/value_figures.h"
#include "tests/climb.h"
#include "tests/reference/random_values.h"
#include "tests/reference/value_truth.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;
using truth::CornersOf;
using truth::Judged;
using truth::kIsFloat;
using truth::NumbersOf;
using truth::ShareOfBound;
using truth::ShownBy;
using truth::TruthAt;

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
  if (method.target != ValueTarget::kValue) {
    for (ValueCorner<T>& v : task.v) v.x = OnSteps<T>(v.x);
  }
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

/// x, y, a and w of the corners, and the point. What a search moved away from 0 stays 0, and a w is
/// 1.
template <class T>
ValueTask<T> TaskOf(const ValueMethod& method, const std::array<double, 14>& c) {
  const auto number = [&](std::size_t k) {
    return std::fabs(c[k]) < 0x1p-60 ? T{0} : static_cast<T>(c[k]);
  };
  ValueTask<T> task;
  for (std::size_t i = 0; i < 3; ++i) {
    const T w = method.space == ValueSpace::kClip ? number(9 + i) : T{0};
    task.v[i] = {number(i), number(3 + i), w == 0 ? T{1} : w};
    task.a[i] = number(6 + i);
  }
  task.x = method.target == ValueTarget::kValue ? number(12) : OnSteps<T>(c[12]);
  task.y = number(13);
  if (method.target == ValueTarget::kAfterSteps) task.steps = 64;
  return task;
}

/// Where a search begins, found by longer ones.
struct Search {
  std::string_view method;
  std::uint64_t seed;
  int evaluations = 3000;
  bool above_powers = false;  ///< of two, in [1, 4); else anything in [1/4, 4)
};
constexpr Search kAnySearch{"", 8};
constexpr std::array kSearches{Search{"edge-products", 20},
                               Search{"differences", 20},
                               Search{"differences-fma", 14},
                               Search{"origin-plane", 29},
                               Search{"vertex-plane", 12},
                               Search{"perspective-planes", 24},
                               Search{"perspective-planes-fma", 8, 20000, true},
                               Search{"inverse-matrix", 27},
                               Search{"perspective-weights", 12},
                               Search{"reciprocal-12-newton", 27},
                               Search{"reciprocal-12-newton-2", 10},
                               Search{"reciprocal-14-newton", 3},
                               Search{"reciprocal-14-newton-2", 3},
                               Search{"quad-difference", 26}};

/// 0, or just above a power of two, where a rounding errs by nearly u, or anything.
double DrawnFor(const Search& search, RandomValues& random) {
  const bool above = search.above_powers;
  const auto is_zero = [&] { return random.Integer(0, above ? 3 : 5) == 0; };
  if (above && is_zero()) return 0;
  const double x = random.LogUniform<double>(above ? 0 : -2, 2);
  if (!above && is_zero()) return 0;
  if (!above && random.Coin()) return x;
  return std::copysign(std::ldexp(1.0, std::ilogb(x)), x) *
         (1 + std::fabs(random.LogUniform<double>(-23, -6)));
}

template <class T>
Peak<14> HighestShare(const ValueMethod& method, int factor) {
  const auto* const found = std::ranges::find(kSearches, method.name, &Search::method);
  const Search& search = found == kSearches.end() ? kAnySearch : *found;
  const int restarts = search.above_powers ? 4 : 8;
  const int evaluations = Cases(search.evaluations * factor / (kIsFloat<T> ? 1 : 4));
  return HighestPeak<14>(
      {.seed = search.seed, .evaluations = evaluations, .restarts = restarts * factor},
      [&](RandomValues& random) { return DrawnFor(search, random); },
      [&](const auto& c) { return ShareOfBound(method, TaskOf<T>(method, c)); });
}

/// What the search has to reach: lowered to this, the bound is seen to fail. Steps have a test of
/// their own, and the conditions at both ends of a difference are seldom reached together.
double FloorOf(const ValueMethod& method) {
  if (method.ulps > 0) return 0.99;
  return method.target == ValueTarget::kValue        ? 0.25
         : method.target == ValueTarget::kDifference ? 0.1
                                                     : 0;
}

/// A row of value_witnesses.cc.
template <class T>
std::string WitnessRow(const ValueMethod& method, const Peak<14>& peak) {
  const ValueTask<T> task = TaskOf<T>(method, peak.at);
  std::string row = fmt::format("    {{\"{}\", {}, {{", method.name, kIsFloat<T>);
  for (const ValueCorner<T>& v : task.v)
    row += fmt::format("{:a}, {:a}, {:a}, ", double{v.x}, double{v.y}, double{v.w});
  for (const T a : task.a) row += fmt::format("{:a}, ", double{a});
  return fmt::format("{}{:a}, {:a}}}, {}}},  // {:.4f}", row, double{task.x}, double{task.y},
                     task.steps, peak.value);
}

template <class T>
void ExpectNoSearchExceedsTheBound(const ValueMethod& method) {
  const Peak<14> peak = HighestShare<T>(method, RunsMore() ? 10 : 1);
  EXPECT_LE(peak.value, 1) << method.name;
  if (kIsFloat<T>) {
    EXPECT_GT(peak.value, FloorOf(method) / (kOneCaseIn > 1 ? 8 : 1)) << method.name;
  }
  // Steps have a search of their own; 0.001 is what the table's three decimals leave out.
  if (method.target == ValueTarget::kAfterSteps) return;
  const double known = LargestRatiosOf(method.name)[kIsFloat<T> ? 0 : 1];
  EXPECT_LE(peak.value, known + 0.001) << "a larger ratio: write down its witness\n"
                                       << WitnessRow<T>(method, peak);
}

TEST(ValueMethods, NoSearchExceedsTheirBounds) {
  for (const ValueMethod& method : ValueMethods()) {
    ExpectNoSearchExceedsTheBound<float>(method);
    ExpectNoSearchExceedsTheBound<double>(method);
  }
}

TEST(ValueMethods, HaveTheConstantsThatTheScriptProves) {
  // reference/proofs/value_methods.g.
  EXPECT_EQ(kInverseMatrixConditions, 524289 * 0x1p-16);
  EXPECT_EQ(kDifferencesConditions, 589825 * 0x1p-16);
  EXPECT_EQ(kPerspectivePlanesConditions, 655361 * 0x1p-16);
  EXPECT_EQ(kFusedPerspectivePlanesConditions, 720897 * 0x1p-16);
  EXPECT_EQ(ReciprocalError<float>(12, 1), 0x1p-24 + 3075 * 0x1p-34);
  EXPECT_EQ(ReciprocalError<double>(14, 1), 0x1p-28 + 3075 * 0x1p-63);
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
  here.x -= static_cast<T>(task.steps);  // to end there
  const T shown = ShownBy(method, here);
  if (shape == Shape::kEqual && shown != task.a[0]) ++broken.equal;
  if (shape == Shape::kAtAVertex) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_here = task.x == task.v[i].x && task.y == task.v[i].y;
      if (is_here && shown != task.a[i]) ++broken.vertices;
    }
  }
  const auto [least, most] = std::ranges::minmax(task.a);
  if (!(shown >= least && shown <= most) && LiesInTheTriangle(task)) {
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
  const auto expect = [&](bool is_kept, int breaches) {
    // One case in sixteen may miss what breaks the others.
    if (is_kept || kOneCaseIn == 1) {
      EXPECT_EQ(is_kept, breaches == 0) << method.name;
    }
  };
  expect(method.equal_stay_equal, broken.equal);
  expect(method.exact_at_vertices, broken.vertices);
  expect(method.stays_in_hull, broken.hull);
}

TEST(ValueMethods, KeepThePromisesOfTheirRowsAndBreakTheOthers) {
  for (const ValueMethod& method : ValueMethods()) {
    if (method.target == ValueTarget::kDifference) continue;
    ExpectPromises<float>(method, Cases(2100));
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

TEST(ValueMethods, SteppingDriftsByHalfAnUlpAStep) {
  // Each step is a little less than half an ulp of the value: ties and less are rounded away.
  const ValueMethod& method = *std::ranges::find(ValueMethods(), "stepped", &ValueMethod::name);
  constexpr float kStep = 0x1p-24F * 0.999F;
  constexpr float kFar = 0x1p20F;
  const ValueTask<float> task{.v = {{{0, 0, 1}, {kFar, 0, 1}, {0, kFar, 1}}},
                              .a = {1, 1 + kStep * kFar, 1},
                              .x = 0,
                              .y = 0,
                              .steps = kMostValueSteps};
  const double share = ShareOfBound(method, task);
  std::printf("[ MEASURED ] stepped, %d steps: error / bound %.3f\n", task.steps, share);
  EXPECT_LE(share, 1);
  EXPECT_GT(share, 0.9);
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
