// The filters run with numbers that write down their roundings: whatever their operations round, a
// sign that they call certain is right, and how few operations more it would take to break that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>
#include <vector>

#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/filters.h"
#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "library/exact_sign.h"
#include "reference/edge_forms.h"
#include "reference/homogeneous_edges.h"
#include "tests/reference/bound_witnesses.h"
#include "tests/reference/perturbed.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;
using testing::Polynomial;
using testing::Roundings;
using Number = testing::Perturbed<double>;
using Numbers = std::vector<double>;

/// Operations beyond the filter's own.
struct More {
  int of_value = 0;
  int of_bound = 0;
};

/// A product with 1 rounds as the proofs count.
Number AfterProducts(Number x, int n) {
  for (; n > 0; --n) x = x * Number(1);
  return x;
}

/// The least that the filter's bound can be, whatever its operations round.
Rational Least(const Number& bound) { return bound.Terms().Exact() - bound.Terms().Deviation(); }

/// The exact value is within the deviation of l - r, the rounded products; fl(l - r) is at most
/// |l - r| / (1 - u). So it has the value's sign beyond the bound if deviation / (1 - u) is below.
Rational ShareOfProducts(const Rational& deviation, const Number& bound) {
  const Rational u(rounding_epsilon<double>());
  return deviation / (Least(bound) * (Rational(1) - u));
}

template <class T>
PointOf<T> PointAt(const Numbers& n, std::size_t first) {
  return {T(n[first]), T(n[first + 1])};
}

Rational ExactEdgeOf(const Numbers& n) {
  return exact::EdgeValue({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]});
}

Rational OracleEdgeShare(const Numbers& n, const More& more) {
  Roundings::Clear(Roundings::Form::kOfResult);
  const exact::EdgeProductsOf<Number> products(PointAt<Number>(n, 0), PointAt<Number>(n, 2),
                                               PointAt<Number>(n, 4));
  const Polynomial value = AfterProducts(products.l, more.of_value).Terms() -
                           AfterProducts(products.r, more.of_value).Terms();
  EXPECT_EQ(value.Here(), ExactEdgeOf(n)) << "the roundings do not explain the error";
  const Rational deviation = value.Deviation();
  const double l = products.l.Value();
  const double r = products.r.Value();

  Roundings::Clear(Roundings::Form::kRelative);
  const exact::FilteredValueOf<Number> filtered = exact::FilterProducts(Number(l), Number(r));
  const exact::EdgeProducts plain(PointAt<double>(n, 0), PointAt<double>(n, 2),
                                  PointAt<double>(n, 4));
  EXPECT_EQ(filtered.value.Value(), plain.Filter().value);
  EXPECT_EQ(filtered.error.Terms().Here(), Rational(plain.Filter().error));
  return ShareOfProducts(deviation, AfterProducts(filtered.error, more.of_bound));
}

Rational ReferenceEdgeShare(const Numbers& n, const More& more) {
  Roundings::Clear(Roundings::Form::kOfResult);
  const library::DirectProducts<Number> products(PointAt<Number>(n, 0), PointAt<Number>(n, 2),
                                                 PointAt<Number>(n, 4));
  const Polynomial value = AfterProducts(products.p1, more.of_value).Terms() -
                           AfterProducts(products.p2, more.of_value).Terms();
  EXPECT_EQ(value.Here(), ExactEdgeOf(n)) << "the roundings do not explain the error";
  const Rational deviation = value.Deviation();
  const double p1 = products.p1.Value();
  const double p2 = products.p2.Value();

  Roundings::Clear(Roundings::Form::kRelative);
  const Number bound = library::FilterBound(Number(p1), Number(p2));
  EXPECT_EQ(bound.Terms().Here(), Rational(library::FilterBound(p1, p2)));
  EXPECT_EQ(library::FilterEdge({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}).value, p1 - p2);
  return ShareOfProducts(deviation, AfterProducts(bound, more.of_bound));
}

template <class T>
exact::Rows3Of<T> Rows(const Numbers& n) {
  exact::Rows3Of<T> rows;
  for (std::size_t k = 0; k < 9; ++k) rows[k / 3][k % 3] = T(n[k]);
  return rows;
}

Rational ExactDeterminant(const Numbers& n) {
  const exact::Rows3 m = Rows<double>(n);
  Rational sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    sum += Rational(m[0][k]) * (Rational(m[1][i]) * m[2][j] - Rational(m[1][j]) * m[2][i]);
  }
  return sum;
}

/// The value is within its deviation of the exact one: it has its sign beyond the bound if the
/// deviation is below.
Rational DeterminantShare(const Numbers& n, const More& more) {
  Roundings::Clear(Roundings::Form::kRelative);
  const exact::FilteredValueOf<Number> filtered = exact::FilterDeterminant(Rows<Number>(n));
  const exact::FilteredValue plain = exact::FilterDeterminant(Rows<double>(n));
  EXPECT_EQ(filtered.value.Terms().Exact(), ExactDeterminant(n));
  EXPECT_EQ(filtered.value.Terms().Here(), Rational(plain.value));
  EXPECT_EQ(filtered.error.Terms().Here(), Rational(plain.error));
  return AfterProducts(filtered.value, more.of_value).Terms().Deviation() /
         Least(AfterProducts(filtered.error, more.of_bound));
}

Rational HomogeneousShare(const Numbers& n, const More& more) {
  const Vertex i{n[0], n[1], 0, n[2]};
  const Vertex j{n[3], n[4], 0, n[5]};
  Roundings::Clear(Roundings::Form::kRelative);
  const Number value = HomogeneousNormal<Number>(i, j).Dot(Number(n[6]), Number(n[7]), Number(1));
  EXPECT_EQ(value.Terms().Exact(), exact::HomogeneousEdgeValue(i, j, {n[6], n[7]}));
  EXPECT_EQ(value.Terms().Here(), Rational(HomogeneousNormal<double>(i, j).Dot(n[6], n[7], 1)));
  const Number bound =
      DotErrorBound(DotMagnitude<Number>(i, j, Number(n[6]), Number(n[7]), Number(1)));
  EXPECT_EQ(bound.Terms().Here(),
            Rational(DotErrorBound(DotMagnitude<double>(i, j, n[6], n[7], 1))));
  return AfterProducts(value, more.of_value).Terms().Deviation() /
         Least(AfterProducts(bound, more.of_bound));
}

/// Numbers whose products are normal, and such that they are not: binades [low, high).
struct Binades {
  int low;
  int high;
};

struct Filter {
  std::string_view name;
  std::string_view constant;
  std::size_t inputs;
  Binades normal;
  Binades underflowing;  ///< none if high is 0
  double floor;          ///< the least share that is reached
  int room;              ///< operations more that the value can have
  bool is_tight;         ///< so that the bound can have none
  Rational (*share)(const Numbers& numbers, const More& more);
};

const std::vector<Filter>& Filters() {
  static const std::vector<Filter> all{{"edge, the oracle's",
                                        "kFilterErrorMultiplier",
                                        6,
                                        {-4, 9},
                                        {-560, -530},
                                        0.999,
                                        0,
                                        true,
                                        OracleEdgeShare},
                                       {"edge, the reference's",
                                        "kFilterErrorMultiplier",
                                        6,
                                        {-4, 9},
                                        {-560, -530},
                                        0.999,
                                        0,
                                        true,
                                        ReferenceEdgeShare},
                                       {"determinant",
                                        "kDeterminantErrorMultiplier",
                                        9,
                                        {-4, 9},
                                        {-362, -357},
                                        0.62,
                                        2,
                                        false,
                                        DeterminantShare},
                                       {"homogeneous edge",
                                        "kHomogeneousErrorMultiplier",
                                        8,
                                        {-4, 9},
                                        {0, 0},
                                        0.99,
                                        0,
                                        false,
                                        HomogeneousShare}};
  return all;
}

Numbers Draw(std::size_t count, const Binades& binades, RandomValues& random) {
  Numbers numbers;
  for (std::size_t k = 0; k < count; ++k) {
    numbers.push_back(random.LogUniform<double>(binades.low, binades.high));
  }
  return numbers;
}

double Largest(const Filter& filter, const std::vector<Numbers>& inputs, const More& more) {
  Rational largest;
  for (const Numbers& numbers : inputs) largest = std::max(largest, filter.share(numbers, more));
  // Beyond 1 by u is beyond it.
  return largest > Rational(1) ? std::max(largest.ToDoubleUp(), std::nextafter(1.0, 2.0))
                               : std::min(largest.ToDouble(), 1.0);
}

/// The witnesses of its bound, and numbers drawn.
std::vector<Numbers> InputsOf(const Filter& filter) {
  std::vector<Numbers> all;
  for (const witness::BoundWitness& w : witness::BoundWitnesses()) {
    if (w.constant == filter.constant) all.push_back(w.numbers);
  }
  EXPECT_FALSE(all.empty()) << filter.name;
  RandomValues random(93);
  for (int k = 0; k < Cases(16); ++k) {
    all.push_back(Draw(filter.inputs, filter.normal, random));
  }
  return all;
}

TEST(PerturbedFilters, AreRightWhateverTheirOperationsRound) {
  for (const Filter& filter : Filters()) {
    const double largest = Largest(filter, InputsOf(filter), {});
    std::cout << filter.name << ": largest a-priori error / least bound " << largest << '\n';
    EXPECT_LE(largest, 1) << filter.name;
    EXPECT_GE(largest, filter.floor) << filter.name;
  }
}

TEST(PerturbedFilters, AreRightWhereProductsUnderflow) {
  RandomValues random(94);
  for (const Filter& filter : Filters()) {
    if (filter.underflowing.high == 0) continue;
    std::vector<Numbers> inputs;
    for (int k = 0; k < Cases(16); ++k) {
      inputs.push_back(Draw(filter.inputs, filter.underflowing, random));
    }
    const double largest = Largest(filter, inputs, {});
    std::cout << filter.name << ", products underflow: " << largest << '\n';
    EXPECT_LE(largest, 1) << filter.name;
    EXPECT_GT(largest, 0.1) << filter.name;
  }
}

TEST(PerturbedFilters, HaveNoRoomForMoreOperationsThanIsSaid) {
  for (const Filter& filter : Filters()) {
    const std::vector<Numbers> inputs = InputsOf(filter);
    EXPECT_LE(Largest(filter, inputs, {.of_value = filter.room}), 1) << filter.name;
    EXPECT_GT(Largest(filter, inputs, {.of_value = filter.room + 1}), 1) << filter.name;
    EXPECT_EQ(Largest(filter, inputs, {.of_bound = 1}) > 1, filter.is_tight) << filter.name;
  }
}

}  // namespace
}  // namespace rasterproof::reference
