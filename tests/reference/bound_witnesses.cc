#include "tests/reference/bound_witnesses.h"

#include <array>

#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/filters.h"
#include "exact/homogeneous.h"
#include "library/exact_sign.h"
#include "reference/barycentric_forms.h"
#include "reference/barycentrics.h"
#include "reference/homogeneous.h"
#include "reference/homogeneous_edges.h"
#include "reference/method.h"

namespace rasterproof::reference::witness {
namespace {

using exact::Rational;
using Numbers = std::vector<double>;

// A method's name, so that a function without captures can be made of it.
template <std::size_t N>
struct Name {
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is written where a name is meant
  constexpr Name(const char (&text)[N]) {
    for (std::size_t k = 0; k < N; ++k) characters[k] = text[k];
  }
  std::array<char, N> characters{};
  std::string_view Text() const { return {characters.data(), N - 1}; }
};

template <Name kMethod>
ErrorAndBound Edge(const Numbers& n) {
  const EdgeEvaluator& edges = *FindMethod(kMethod.Text())->edges;
  const Point2 a{n[0], n[1]};
  const Point2 b{n[2], n[3]};
  const Point2 p{n[4], n[5]};
  return {(Rational(edges.Value(a, b, p)) - exact::EdgeValue(a, b, p)).Abs(),
          Rational(edges.ErrorBound(a, b, p))};
}

// One pixel to the right.
template <Name kMethod>
ErrorAndBound AfterStep(const Numbers& n) {
  const EdgeEvaluator& edges = *FindMethod(kMethod.Text())->edges;
  const Point2 a{n[0], n[1]};
  const Point2 b{n[2], n[3]};
  const Point2 p{n[4], n[5]};
  const Rational exact = exact::EdgeValue(a, b, {p.x + 1, p.y});
  return {(Rational(edges.Steps(a, b, p, Step{}, 1)[1]) - exact).Abs(),
          Rational(edges.SteppingErrorBounds(a, b, p, Step{}, 1)[1])};
}

template <class T>
ErrorAndBound Homogeneous(const Numbers& n) {
  const Vertex i{n[0], n[1], 0, n[2]};
  const Vertex j{n[3], n[4], 0, n[5]};
  const auto product = [](double x, double y) { return (Rational(x) * y).Abs(); };
  const Rational terms = (product(j.y, i.w) + product(j.w, i.y)) * Rational(n[6]).Abs() +
                         (product(j.w, i.x) + product(j.x, i.w)) * Rational(n[7]).Abs() +
                         product(j.x, i.y) + product(j.y, i.x);
  const T value = HomogeneousNormal<T>(i, j).Dot(static_cast<T>(n[6]), static_cast<T>(n[7]), T{1});
  return {(Rational(value) - exact::HomogeneousEdgeValue(i, j, {n[6], n[7]})).Abs(),
          terms * kHomogeneousErrorMultiplier<T> * rounding_epsilon<T>()};
}

template <class T>
ErrorAndBound SumOfQuotients(const Numbers& n) {
  const std::array<T, 3> l =
      OverTheirSum<T>({static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2])});
  return {(Rational(l[0]) + l[1] + l[2] - 1).Abs(),
          Rational(kNormalizedSumErrorMultiplier<T>) * rounding_epsilon<T>()};
}

template <class T>
ErrorAndBound SumWithOneMinus(const Numbers& n) {
  const T l2 = LastOfOne(T{1}, static_cast<T>(n[0]), static_cast<T>(n[1]));
  return {(Rational(n[0]) + n[1] + l2 - 1).Abs(), Rational(kOneMinusSumError<T>)};
}

template <class T>
ErrorAndBound Distance(const Numbers& n) {
  const T area = static_cast<T>(n[1]);
  const T distance = (static_cast<T>(n[0]) / area) * (area / static_cast<T>(n[2]));
  return {(Rational(distance) * n[2] - n[0]).Abs(),
          Rational(n[0]) * kEdgeDistanceErrorMultiplier<T> * rounding_epsilon<T>()};
}

ErrorAndBound EdgeFilter(const Numbers& n) {
  const double l = (n[4] - n[0]) * (n[3] - n[1]);
  const double r = (n[5] - n[1]) * (n[2] - n[0]);
  const Rational exact = exact::EdgeValue({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]});
  return {(Rational(l) - r - exact).Abs(), Rational(library::FilterBound(l, r))};
}

ErrorAndBound DeterminantFilter(const Numbers& n) {
  const exact::Rows3 m{{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}};
  Rational exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    exact += Rational(m[0][k]) * (Rational(m[1][i]) * m[2][j] - Rational(m[1][j]) * m[2][i]);
  }
  const exact::FilteredValue filtered = exact::FilterDeterminant(m);
  return {(Rational(filtered.value) - exact).Abs(), Rational(filtered.error)};
}

constexpr std::string_view kEdge = "a.x a.y b.x b.y p.x p.y";
constexpr std::string_view kClip = "Vi.x Vi.y Vi.w Vj.x Vj.y Vj.w p.x p.y";

}  // namespace

double BoundWitness::Ratio() const {
  const ErrorAndBound found = evaluate(numbers);
  return (found.error / found.bound).ToDouble();
}

bool BoundWitness::IsTight() const {
  const ErrorAndBound found = evaluate(numbers);
  return found.error * 100 > found.bound * 99;
}

namespace {

// Where no comment says otherwise they were constructed, 2026-11-25.
std::vector<BoundWitness> FormWitnesses() {
  return {
      {"direct (`f32-direct`)",
       "kDirectEdgeErrorMultiplier",
       true,
       kEdge,
       {0x1.ffc3e4p-2, 0x1.ffbffcp-2, 0x1.8000fap+0, 0x1.800106p+0, 0x1.8p+0, 0x1.8p+0},
       Edge<"f32-direct">},
      {"direct (`f32-index`)",
       "kDirectEdgeErrorMultiplier",
       true,
       kEdge,
       {0x1.ffc3e4p-2, 0x1.ffbffcp-2, 0x1.8000fap+0, 0x1.800106p+0, 0x1.8p+0, 0x1.8p+0},
       Edge<"f32-index">},
      {"direct (`f64-direct`)",
       "kDirectEdgeErrorMultiplier",
       false,
       kEdge,
       {0x1.ffffff4afb712p-2, 0x1.ffffff4afb0cep-2, 0x1.8000000000191p+0, 0x1.8000000000191p+0,
        0x1.8p+0, 0x1.8p+0},
       Edge<"f64-direct">},
      {"direct, fused (`f32-direct-fma`)",
       "kDirectFmaEdgeErrorMultiplier",
       true,
       kEdge,
       {0x1.ffc004p-2, 0x1.fff938p-3, 0x1.ffc046p-2, 0x1.400f28p+0, 0x1.800002p+0, 0x1.83da32p-3},
       // climbed from a construction, seed 3, 2026-11-25
       Edge<"f32-direct-fma">},
      {"Kahan's (`f32-kahan`)",
       "kKahanEdgeErrorMultiplier",
       true,
       kEdge,
       {0x1.fffff4p-2, 0x1.ffffecp-2, 0x1.800002p+0, 0x1.7ffffep+0, 0x1.8p+0, 0x1.7ffffcp+0},
       // climbed from a construction, seed 4, 2026-11-25
       Edge<"f32-kahan">},
      {"Kahan's (`f64-kahan`)",
       "kKahanEdgeErrorMultiplier",
       false,
       kEdge,
       {0x1.ffffffffffffap-2, 0x1.ffffffffffffep-2, 0x1.8000000000001p+0, 0x1.8000000000001p+0,
        0x1.8p+0, 0x1.8p+0},
       Edge<"f64-kahan">},
      {"affine (`f32-affine`)",
       "kAffineLineErrorMultiplier, kAffineConstantErrorMultiplier",
       true,
       kEdge,
       {-0x1.ffe03p-1, 0x1.001016p+0, 0x1.ffdfdap-25, 0x1.001018p+0, 0x1.000d26p+0, 0x1.002a36p-24},
       // climbed from a construction, seed 3, 2026-11-25
       Edge<"f32-affine">},
      {"affine, fused (`f32-affine-fma`)",
       "kAffineFmaLineErrorMultiplier, kAffineFmaConstantErrorMultiplier",
       true,
       kEdge,
       {-0x1.000ffep+0, 0x1.0016ap+0, 0x1p-24, 0x1.001004p+0, 0x1.7fb288p-2, -0x1.ffe002p-1},
       // climbed from a construction, seed 2, 2026-11-25
       Edge<"f32-affine-fma">},
      {"a step (`f32-incremental`)",
       "SumRoundingError",
       true,
       kEdge,
       {0, 0, 0, 0x1.000002p+0, 0x1p-1, 0},
       AfterStep<"f32-incremental">},
      {"a step (`f32-incremental-compensated`)",
       "SumRoundingError",
       true,
       kEdge,
       {0, 0, 0, 0x1.000002p+0, 0x1p-1, 0},
       AfterStep<"f32-incremental-compensated">},
      {"a step (`f32-index-fma`)",
       "SumRoundingError",
       true,
       kEdge,
       {0, 0, 0, 0x1.000002p+0, 0x1p-1, 0},
       AfterStep<"f32-index-fma">},
      {"a step (`f64-incremental`)",
       "SumRoundingError",
       false,
       kEdge,
       {0, 0, 0, 0x1.0000000000001p+0, 0x1p-1, 0},
       AfterStep<"f64-incremental">},
      {"homogeneous, float32",
       "kHomogeneousErrorMultiplier",
       true,
       kClip,
       {-0x1.ffe002p-25, -0x1.000012p-24, 0x1.001p+0, 0, 0x1.001p+0, 0x1.ffffdep-1, 0x1.ffdp-1,
        -0x1.001012p+0},
       // climbed from a construction, seed 3, 2026-11-25
       Homogeneous<float>},
      {"homogeneous, float64",
       "kHomogeneousErrorMultiplier",
       false,
       kClip,
       {-0x1.00002a19033c1p-53, -0x1.00001259571cbp-53, 0x1.00000296f046dp+0, 0,
        0x1.000006058c6d1p+0, 0x1.ffffdb4d54682p-1, 0x1.0000001ea84fdp+0, -0x1.ffffd080af90bp-1},
       // climbed from a construction, seed 1, 2026-11-25
       Homogeneous<double>},
      {"sum of quotients by the sum, float32",
       "kNormalizedSumErrorMultiplier",
       true,
       "E_0 E_1 E_2",
       {0x1.14a1f4p-1, 0x1.d6c0acp-2, 0x1.dd4p-14},
       // constructed, 2026-11-26
       SumOfQuotients<float>},
      {"sum of quotients by the sum, float64",
       "kNormalizedSumErrorMultiplier",
       false,
       "E_0 E_1 E_2",
       {0x1.1d060037433cfp-1, 0x1.c5f3ffd5ab1b4p-2, 0x1.f4fa81p-29},
       // constructed, 2026-11-26
       SumOfQuotients<double>},
      {"sum with (1 - l0) - l1, float32",
       "kOneMinusSumError",
       true,
       "l_0 l_1",
       {0x1p-25, 0x1p-25},
       SumWithOneMinus<float>},
      {"sum with (1 - l0) - l1, float64",
       "kOneMinusSumError",
       false,
       "l_0 l_1",
       {0x1p-54, 0x1p-54},
       SumWithOneMinus<double>},
      {"distance by a barycentric, float32",
       "kEdgeDistanceErrorMultiplier",
       true,
       "E A height",
       {0x1.007c1p+0, 0x1.00401ep+0, 0x1.003bd6p+0},
       // climbed, seed 2, 2026-11-25
       Distance<float>},
      {"distance by a barycentric, float64",
       "kEdgeDistanceErrorMultiplier",
       false,
       "E A height",
       {0x1.00004134284ffp+0, 0x1.ffffffffffe1bp-1, 0x1.ffe8cf5980b05p-1},
       // climbed, seed 1, 2026-11-25
       Distance<double>},
      {"filter of an edge",
       "kFilterErrorMultiplier",
       false,
       kEdge,
       {0x1.ffffff4afb712p-2, 0x1.ffffff4afb0cep-2, 0x1.8000000000191p+0, 0x1.8000000000191p+0,
        0x1.8p+0, 0x1.8p+0},
       EdgeFilter},
      {"filter of a 3x3 determinant",
       "kDeterminantErrorMultiplier",
       false,
       "rows",
       {0x1.ffffff13a4271p-1, 0x1.ffeefc1ff5754p-54, 0x1.fffacb8864b11p-1, -0x1.00088206af52cp+0,
        0x1.0000007b94165p+0, 0x1.0005e7b4bd692p+0, 0, -0x1.fff430dc41204p-54,
        0x1.00000031b7a79p+0},
       // climbed from a construction, seed 2, 2026-11-25
       DeterminantFilter},
  };
}

}  // namespace

const std::vector<BoundWitness>& BoundWitnesses() {
  static const std::vector<BoundWitness> all = [] {
    std::vector<BoundWitness> both = FormWitnesses();
    both.insert(both.end(), CrossingWitnesses().begin(), CrossingWitnesses().end());
    return both;
  }();
  return all;
}

}  // namespace rasterproof::reference::witness
