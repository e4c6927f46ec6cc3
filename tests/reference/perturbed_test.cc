// From the code to the products of (1 + d) that the proofs start from: the very templates of
// reference/ run with numbers that write down their roundings. What a form's own operations can
// make of its value is held to the header's constant, and one operation more breaks it.
#include "tests/reference/perturbed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "reference/barycentric_forms.h"
#include "reference/barycentrics.h"
#include "reference/bounds.h"
#include "reference/edge_forms.h"
#include "reference/edge_walks.h"
#include "reference/homogeneous.h"
#include "reference/homogeneous_edges.h"
#include "tests/reference/bound_witnesses.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;
using testing::Perturbed;
using testing::Polynomial;
using testing::Roundings;
using Numbers = std::vector<double>;
using Stated = Roundings::Form;

/// What one expression made of its numbers: the polynomial of its value less the exact value has
/// the constant 0.
struct Made {
  Polynomial off;
  Rational error;  ///< of the same template, run with plain floats
  Rational bound;  ///< the header's
};

/// Holds the polynomial to the error that it has to explain. Returns its largest value / bound.
double Share(const Made& made) {
  EXPECT_EQ(made.off.Exact().Sign(), 0) << "the exact value is not the form's";
  EXPECT_EQ(made.off.Here(), made.error) << "the roundings do not explain the error";
  const Rational deviation = made.off.Deviation();
  EXPECT_LE(made.error.Abs(), deviation);
  return (deviation / made.bound).ToDouble();
}

Point2 A(const Numbers& n) { return {n[0], n[1]}; }
Point2 B(const Numbers& n) { return {n[2], n[3]}; }
Point2 P(const Numbers& n) { return {n[4], n[5]}; }
Rational Size(const Rational& x, const Rational& y) { return (x * y).Abs(); }

/// S, and the sums of the line's and the constant's products.
Rational SumOfProducts(const Numbers& n) {
  return Size(Rational(n[4]) - n[0], Rational(n[3]) - n[1]) +
         Size(Rational(n[5]) - n[1], Rational(n[2]) - n[0]);
}
Rational LineProducts(const Numbers& n) {
  return Size(n[4], Rational(n[3]) - n[1]) + Size(n[5], Rational(n[2]) - n[0]);
}
Rational ConstantProducts(const Numbers& n) { return Size(n[2], n[1]) + Size(n[0], n[3]); }

/// The header's bounds, term by term.
template <class F>
Rational BoundOf(const DirectForm<F>& /*form*/, const Numbers& n) {
  const Rational u(rounding_epsilon<F>());
  return u * kDirectEdgeErrorMultiplier<F> * SumOfProducts(n) +
         u * exact::EdgeValue(A(n), B(n), P(n)).Abs();
}
template <class F>
Rational BoundOf(const DirectFmaForm<F>& /*form*/, const Numbers& n) {
  const Rational u(rounding_epsilon<F>());
  return u * kDirectFmaEdgeErrorMultiplier<F> * SumOfProducts(n) +
         u * exact::EdgeValue(A(n), B(n), P(n)).Abs();
}
template <class F>
Rational BoundOf(const KahanForm<F>& /*form*/, const Numbers& n) {
  return Rational(rounding_epsilon<F>()) * kKahanEdgeErrorMultiplier<F> * SumOfProducts(n) +
         exact::EdgeValue(A(n), B(n), P(n)).Abs() * kKahanEdgeRelError<F>;
}
template <class F>
Rational BoundOf(const AffineForm<F>& /*form*/, const Numbers& n) {
  return Rational(rounding_epsilon<F>()) *
         (LineProducts(n) * kAffineLineErrorMultiplier<F> +
          ConstantProducts(n) * kAffineConstantErrorMultiplier<F>);
}
template <class F>
Rational BoundOf(const AffineFmaForm<F>& /*form*/, const Numbers& n) {
  return Rational(rounding_epsilon<F>()) *
         (LineProducts(n) * kAffineFmaLineErrorMultiplier<F> +
          ConstantProducts(n) * kAffineFmaConstantErrorMultiplier<F>);
}

/// One operation more, or none: a product with 1, which a proof has to count like any other.
template <class T>
T Again(const T& value, bool again) {
  return again ? value * T(1) : value;
}

/// Operations more of which one rounds by half an ulp: 3 v needs two bits more than v.
template <class T>
T Detour(const T& value, bool again) {
  return again ? value * T(3) - (value + value) : value;
}

template <class T, template <class> class Form>
T EdgeAt(const Numbers& n, bool again) {
  const Form<T> form(Form<T>::Convert(A(n)), Form<T>::Convert(B(n)), false);
  return Again(form.At(T(static_cast<T>(n[4])), T(static_cast<T>(n[5]))), again);
}

template <class F, template <class> class Form>
double Edge(const Numbers& n, bool again) {
  Roundings::Clear(Stated::kRelative);
  const auto value = EdgeAt<Perturbed<F>, Form>(n, again);
  const Rational exact = exact::EdgeValue(A(n), B(n), P(n));
  const Form<F> plain(Form<F>::Convert(A(n)), Form<F>::Convert(B(n)), false);
  return Share({value.Terms() - Polynomial(exact), Rational(EdgeAt<F, Form>(n, again)) - exact,
                BoundOf(plain, n)});
}

template <class T>
T HomogeneousAt(const Numbers& n, bool again) {
  const Vertex i{n[0], n[1], 0, n[2]};
  const Vertex j{n[3], n[4], 0, n[5]};
  const T value = HomogeneousNormal<T>(i, j).Dot(static_cast<T>(n[6]), static_cast<T>(n[7]), T(1));
  return Again(value, again);
}

template <class F>
double Homogeneous(const Numbers& n, bool again) {
  Roundings::Clear(Stated::kRelative);
  const auto value = HomogeneousAt<Perturbed<F>>(n, again);
  const Rational exact =
      exact::HomogeneousEdgeValue({n[0], n[1], 0, n[2]}, {n[3], n[4], 0, n[5]}, {n[6], n[7]});
  const Rational terms = (Size(n[4], n[2]) + Size(n[5], n[1])) * Rational(n[6]).Abs() +
                         (Size(n[5], n[0]) + Size(n[3], n[2])) * Rational(n[7]).Abs() +
                         Size(n[3], n[1]) + Size(n[4], n[0]);
  return Share({value.Terms() - Polynomial(exact), Rational(HomogeneousAt<F>(n, again)) - exact,
                terms * kHomogeneousErrorMultiplier<F> * rounding_epsilon<F>()});
}

template <class T>
std::array<T, 3> Quotients(const Numbers& n, bool again) {
  const std::array<T, 3> e{static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2])};
  if (!again) return OverTheirSum<T>(e);
  const T sum = Detour((e[0] + e[1]) + e[2], true);
  return {e[0] / sum, e[1] / sum, e[2] / sum};
}

template <class F>
double SumOfQuotients(const Numbers& n, bool again) {
  Roundings::Clear(Stated::kHalfUlp);
  const auto l = Quotients<Perturbed<F>>(n, again);
  const std::array<F, 3> plain = Quotients<F>(n, again);
  return Share({l[0].Terms() + l[1].Terms() + l[2].Terms() - Polynomial(1),
                Rational(plain[0]) + plain[1] + plain[2] - 1,
                Rational(kNormalizedSumErrorMultiplier<F>) * rounding_epsilon<F>()});
}

/// The extra operation has to round: a difference from one half first.
template <class T>
T LastAt(const T& l0, const T& l1, bool again) {
  return again ? ((T(0.5) - l0) + T(0.5)) - l1 : LastOfOne(T(1), l0, l1);
}

template <class F>
double SumWithOneMinus(const Numbers& n, bool again) {
  using T = Perturbed<F>;
  Roundings::Clear(Stated::kHalfUlp);
  const T l2 = LastAt<T>(n[0], n[1], again);
  const F plain = LastAt<F>(static_cast<F>(n[0]), static_cast<F>(n[1]), again);
  const Rational others = Rational(n[0]) + n[1] - 1;
  return Share({l2.Terms() + Polynomial(others), others + plain, Rational(kOneMinusSumError<F>)});
}

/// As EdgeDistances has it, which is no template: the expression is copied.
template <class T>
T DistanceAt(const Numbers& n, bool again) {
  const T area = static_cast<T>(n[1]);
  return Again((static_cast<T>(n[0]) / area) * (area / static_cast<T>(n[2])), again);
}

template <class F>
double Distance(const Numbers& n, bool again) {
  Roundings::Clear(Stated::kRelative);
  const Rational exact = Rational(n[0]) / n[2];
  return Share({DistanceAt<Perturbed<F>>(n, again).Terms() - Polynomial(exact),
                Rational(DistanceAt<F>(n, again)) - exact,
                exact.Abs() * kEdgeDistanceErrorMultiplier<F> * rounding_epsilon<F>()});
}

constexpr int kSteps = 3;

/// E after kSteps columns from the centre of the pixel that the last two numbers name.
template <class Walk>
typename Walk::T Walked(const Numbers& n, bool again) {
  using Form = typename Walk::Form;
  const int x0 = static_cast<int>(n[4]);
  const int y0 = static_cast<int>(n[5]);
  Walk walk(Form(Form::Convert(A(n)), Form::Convert(B(n)), false), x0, y0);
  auto cursor = walk.RowStart(y0);
  for (int k = 0; k < kSteps; ++k) cursor.Next();
  return Detour(cursor.Value(x0 + kSteps), again);
}

template <class F, template <class> class Walk, EdgeArithmetic kArithmetic>
double WalkShare(const Numbers& n, bool again) {
  using Run = Walk<DirectForm<Perturbed<F>>>;
  Roundings::Clear(Stated::kHalfUlp);
  const auto value = Walked<Run>(n, again);
  constexpr Precision kPrecision =
      sizeof(F) == sizeof(float) ? Precision::kFloat32 : Precision::kFloat64;
  const Point2 start{n[4] + 0.5, n[5] + 0.5};
  const Rational exact = exact::EdgeValue(A(n), B(n), {start.x + kSteps, start.y});
  return Share(
      {value.Terms() - Polynomial(exact), Rational(Walked<Walk<DirectForm<F>>>(n, again)) - exact,
       SteppingErrorBounds(kArithmetic, kPrecision, A(n), B(n), start, Step{}, kSteps)[kSteps]});
}

template <class Form>
using PlainWalk = CornerWalk<Form>;

/// All walks whose steps are templates: FusedSum calls std::fma and is none.
template <class F>
std::array<double (*)(const Numbers&, bool), 5> Walks() {
  return {WalkShare<F, PlainWalk, EdgeArithmetic::kIncremental>,
          WalkShare<F, RowWalk, EdgeArithmetic::kIncrementalRow>,
          WalkShare<F, AnchoredWalk, EdgeArithmetic::kIncremental16>,
          WalkShare<F, CompensatedWalk, EdgeArithmetic::kCompensated>,
          WalkShare<F, PlainIndexWalk, EdgeArithmetic::kIndex>};
}

/// An edge whose start is exact and whose steps are not, and edges drawn.
template <class F>
std::vector<Numbers> WalkInputs() {
  constexpr double kUlp = std::numeric_limits<F>::epsilon();
  std::vector<Numbers> all{{0, 0.5, 0, 1.5 + kUlp, 0, 0}};
  RandomValues random(92);
  for (int k = 0; k < Cases(200); ++k) {
    Numbers numbers;
    for (int c = 0; c < 4; ++c) numbers.push_back(random.LogUniform<F>(-2, 7));
    numbers.push_back(kReanchorSteps * random.Integer(0, 3));
    numbers.push_back(random.Integer(0, 60));
    all.push_back(numbers);
  }
  return all;
}

template <class F>
void HoldWalks() {
  for (const auto share : Walks<F>()) {
    double largest = 0;
    double broken = 0;
    for (const Numbers& numbers : WalkInputs<F>()) {
      largest = std::max(largest, share(numbers, false));
      broken = std::max(broken, share(numbers, true));
    }
    std::cout << "walk: largest a-priori error / bound " << largest << ", of one operation more "
              << broken << '\n';
    EXPECT_LE(largest, 1);
    EXPECT_GE(largest, 0.5);
    EXPECT_GT(broken, 1);
  }
}

/// An expression and the numbers to try it on.
struct Expression {
  std::string_view name;
  std::string_view constant;  ///< the first of those that its witnesses name
  bool is_float32;
  std::size_t inputs;
  int low, high;  ///< binades of the numbers drawn
  bool positive;
  double floor;  ///< the least share that is reached: the constant counts no rounding in vain
  double (*share)(const Numbers& numbers, bool again);
};

template <class F>
void Append(std::vector<Expression>& all) {
  constexpr bool k32 = sizeof(F) == sizeof(float);
  all.insert(
      all.end(),
      {{"direct", "kDirectEdgeErrorMultiplier", k32, 6, -4, 9, false, 0.999, Edge<F, DirectForm>},
       {"direct, fused", "kDirectFmaEdgeErrorMultiplier", k32, 6, -4, 9, false, 0.99,
        Edge<F, DirectFmaForm>},
       {"Kahan's", "kKahanEdgeErrorMultiplier", k32, 6, -4, 9, false, 0.999, Edge<F, KahanForm>},
       {"affine", "kAffineLineErrorMultiplier", k32, 6, -4, 9, false, 0.99, Edge<F, AffineForm>},
       {"affine, fused", "kAffineFmaLineErrorMultiplier", k32, 6, -4, 9, false, 0.99,
        Edge<F, AffineFmaForm>},
       {"homogeneous", "kHomogeneousErrorMultiplier", k32, 8, -4, 9, false, 0.99, Homogeneous<F>},
       {"sum of quotients", "kNormalizedSumErrorMultiplier", k32, 3, -4, 9, true, 0.99,
        SumOfQuotients<F>},
       {"sum with (1 - l0) - l1", "kOneMinusSumError", k32, 2, -12, -1, true, 0.999,
        SumWithOneMinus<F>},
       {"distance", "kEdgeDistanceErrorMultiplier", k32, 3, -4, 9, true, 0.999, Distance<F>}});
}

std::vector<Expression> Expressions() {
  std::vector<Expression> all;
  Append<float>(all);
  Append<double>(all);
  return all;
}

Numbers Draw(const Expression& expression, RandomValues& random) {
  Numbers numbers;
  for (std::size_t k = 0; k < expression.inputs; ++k) {
    const double x = expression.is_float32
                         ? double{random.LogUniform<float>(expression.low, expression.high)}
                         : random.LogUniform<double>(expression.low, expression.high);
    numbers.push_back(expression.positive ? std::fabs(x) : x);
  }
  return numbers;
}

/// The witnesses of its bound, and numbers drawn.
std::vector<Numbers> Inputs(const Expression& expression, int drawn) {
  std::vector<Numbers> all;
  for (const witness::BoundWitness& w : witness::BoundWitnesses()) {
    const bool is_of = w.constant.substr(0, w.constant.find(',')) == expression.constant;
    // A float is a double, too.
    if (is_of && (w.is_float32 || !expression.is_float32)) all.push_back(w.numbers);
  }
  EXPECT_FALSE(all.empty()) << expression.name;
  RandomValues random(91);
  for (int k = 0; k < drawn; ++k) all.push_back(Draw(expression, random));
  return all;
}

double LargestShare(const Expression& expression, bool again) {
  double largest = 0;
  for (const Numbers& numbers : Inputs(expression, Cases(200))) {
    largest = std::max(largest, expression.share(numbers, again));
  }
  return largest;
}

TEST(Perturbed, WhatAFormsOperationsCanRoundIsWithinItsBound) {
  for (const Expression& expression : Expressions()) {
    const double largest = LargestShare(expression, false);
    std::cout << expression.name << (expression.is_float32 ? ", float32" : ", float64")
              << ": largest a-priori error / bound " << largest << '\n';
    EXPECT_LE(largest, 1) << expression.name;
    EXPECT_GE(largest, expression.floor) << expression.name;
  }
}

TEST(Perturbed, OneOperationMoreIsBeyondTheBound) {
  for (const Expression& expression : Expressions()) {
    EXPECT_GT(LargestShare(expression, true), 1) << expression.name;
  }
}

TEST(Perturbed, WhatAWalksStepsCanRoundIsWithinItsBoundAndOneMoreIsNot) {
  HoldWalks<float>();
  HoldWalks<double>();
}

template <template <class> class Form>
std::size_t RoundingsOf() {
  Roundings::Clear(Stated::kRelative);
  EdgeAt<Perturbed<float>, Form>({1.5, 2.25, 7.75, 9.5, 3.125, 11.25}, false);
  return Roundings::Count();
}

TEST(Perturbed, CountsEveryOperationThatMayRound) {
  EXPECT_EQ(RoundingsOf<DirectForm>(), 7U);     // 4 differences, 2 products, 1 difference
  EXPECT_EQ(RoundingsOf<DirectFmaForm>(), 6U);  // one product less
  EXPECT_EQ(RoundingsOf<KahanForm>(), 7U);      // the product's error is exact
  EXPECT_EQ(RoundingsOf<AffineForm>(), 9U);     // 2 differences, C 3, 2 products, 2 sums
  EXPECT_EQ(RoundingsOf<AffineFmaForm>(), 6U);  // 2 differences, C 2, 2 fused
}

TEST(Perturbed, RefusesWhatItsRoundingsDoNotExplain) {
  using T = Perturbed<float>;
  Roundings::Clear(Stated::kRelative);
  EXPECT_THROW(T(0.1), std::invalid_argument);
  EXPECT_EQ((T(0x1p-149) * T(0.75)).Terms().Deviation(), Rational(0x1p-150)) << "it underflows";
  Roundings::Clear(Stated::kHalfUlp);
  EXPECT_THROW(T(0x1p-149) * T(0.75), std::logic_error) << "the same";
  Roundings::Clear(Stated::kOfResult);
  EXPECT_THROW(T(1) / T(3), std::logic_error) << "a quotient";
  Roundings::Clear(Stated::kRelative);
  for (int k = 1; k <= 32; ++k) T(1) + T(k);
  EXPECT_THROW(T(1) + T(33), std::length_error);
}

}  // namespace
}  // namespace rasterproof::reference
