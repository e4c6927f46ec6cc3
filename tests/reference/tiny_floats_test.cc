// Formulas and their bounds on all numbers of a few bits: exhausted, where other tests sample. What
// breaks a derivation by the relative errors of its operations breaks it at three bits as well.
//
// RASTERPROOF_TINY=3 gives the edge function all 25^6 = 244,140,625 sixes of numbers of 3 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/ulp.h"
#include "reference/barycentric_forms.h"
#include "reference/barycentrics.h"
#include "reference/bounds.h"
#include "reference/edge_forms.h"
#include "tests/reference/random_values.h"
#include "tests/reference/tiny_float.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using testing::TinyFloat;

// All in double, exact: a few bits each, within a few binades.
struct Tried {
  std::uint64_t cases = 0;
  double worst = 0;

  void Add(double error, double bound) {
    ++cases;
    if (error == 0) return;
    if (!(error <= bound)) worst = INFINITY;
    worst = std::max(worst, error / bound);
  }
  void Report(std::string_view formula, int p) const {
    std::cout << formula << ", p = " << p << ": all " << cases << " cases, largest error / bound "
              << worst << '\n';
    EXPECT_LE(worst, 1) << formula << ", p = " << p;
    EXPECT_GT(cases, 0U);
  }
};

// The edge a -> b at (x, y): its exact value, and the sum of the products' magnitudes.
struct ExactEdge {
  double value;
  double sum;
  double line;
  double constant;
};

ExactEdge ExactAt(double ax, double ay, double bx, double by, double x, double y) {
  const double one = (x - ax) * (by - ay);
  const double two = (y - ay) * (bx - ax);
  return {one - two, std::fabs(one) + std::fabs(two),
          std::fabs((by - ay) * x) + std::fabs((bx - ax) * y),
          std::fabs(bx * ay) + std::fabs(ax * by)};
}

template <int p>
class EdgeWorld {
 public:
  using T = TinyFloat<p>;
  static constexpr double kUnit = rounding_epsilon<T>();

  void Run() {
    const std::vector<T> all = T::All(3);
    for (const T ax : all) {
      for (const T ay : all) {
        for (const T bx : all) {
          for (const T by : all) AtAll(all, {ax, ay}, {bx, by});
        }
      }
    }
    direct_.Report("direct", p);
    fma_.Report("direct-fma", p);
    kahan_.Report("Kahan", p);
    affine_.Report("affine", p);
    affine_fma_.Report("affine-fma", p);
  }

 private:
  using Point = PointOf<T>;

  void AtAll(const std::vector<T>& all, Point a, Point b) {
    const DirectForm<T> direct(a, b, false);
    const DirectFmaForm<T> fused(a, b, false);
    const KahanForm<T> kahan(a, b, false);
    const AffineForm<T> affine(a, b, false);
    const AffineFmaForm<T> affine_fma(a, b, false);
    for (const T x : all) {
      for (const T y : all) {
        const ExactEdge e = ExactAt(a.x, a.y, b.x, b.y, x, y);
        const double size = std::fabs(e.value);
        const auto off = [&](T value) { return std::fabs(value - e.value); };
        direct_.Add(off(direct.At(x, y)),
                    kDirectEdgeErrorMultiplier<T> * kUnit * e.sum + kUnit * size);
        fma_.Add(off(fused.At(x, y)),
                 kDirectFmaEdgeErrorMultiplier<T> * kUnit * e.sum + kUnit * size);
        kahan_.Add(off(kahan.At(x, y)),
                   kKahanEdgeErrorMultiplier<T> * kUnit * e.sum + kKahanEdgeRelError<T> * size);
        affine_.Add(off(affine.At(x, y)), kUnit * (kAffineLineErrorMultiplier<T> * e.line +
                                                   kAffineConstantErrorMultiplier<T> * e.constant));
        affine_fma_.Add(off(affine_fma.At(x, y)),
                        kUnit * (kAffineFmaLineErrorMultiplier<T> * e.line +
                                 kAffineFmaConstantErrorMultiplier<T> * e.constant));
      }
    }
  }

  Tried direct_;
  Tried fma_;
  Tried kahan_;
  Tried affine_;
  Tried affine_fma_;
};

TEST(TinyFloats, RoundToNearestTiesToEven) {
  using T = TinyFloat<3>;  // 1, 1.25, 1.5, 1.75, 2, 2.5, ...
  EXPECT_EQ(T(1.125), 1);
  EXPECT_EQ(T(1.375), 1.5);
  EXPECT_EQ(T(1.3), 1.25);
  EXPECT_EQ(T(1.875), 2);
  EXPECT_EQ(T(2.25), 2);
  EXPECT_EQ(T(-2.75), -3);
  EXPECT_EQ(T(0), 0);
  EXPECT_EQ(fma(T(1.25), T(1.25), -T(1.5)), 0.0625);
  EXPECT_EQ(rounding_epsilon<T>(), 0.125);
  EXPECT_EQ(T::All(3).size(), 25U);
  for (const T x : T::All(4)) EXPECT_EQ(T(static_cast<double>(x)), x);
}

TEST(TinyFloats, EdgeFormsStayWithinTheirBounds) {
  EdgeWorld<2>().Run();
  const char* more = std::getenv("RASTERPROOF_TINY");
  if (more != nullptr && std::string_view(more) == "3") EdgeWorld<3>().Run();
}

// Its sign is that of the exact value wherever the differences are exact, which each is here by
// itself: a b - c d of any four.
template <int p>
void DifferencesOfProducts(int binades) {
  using T = TinyFloat<p>;
  constexpr double kUnit = rounding_epsilon<T>();
  const std::vector<T> all = T::All(binades);
  Tried tried;
  for (const T a : all) {
    for (const T b : all) {
      for (const T c : all) {
        for (const T d : all) {
          const double exact = a * static_cast<double>(b) - c * static_cast<double>(d);
          // The edge from (0, 0) to (c, b) at (a, d).
          const KahanForm<T> form({T(), T()}, {c, b}, false);
          tried.Add(std::fabs(form.At(a, d) - exact), 2 * kUnit * std::fabs(exact));
        }
      }
    }
  }
  tried.Report("Kahan's difference of products, 2u |ab - cd|", p);
}

TEST(TinyFloats, KahansDifferenceOfProductsIsWithinTwoUnitsOfItself) {
  DifferencesOfProducts<3>(4);
  DifferencesOfProducts<4>(3);
  if (kOneCaseIn == 1) DifferencesOfProducts<5>(2);
}

// Any four numbers of p bits, but for what scaling and exchanging signs leave alike: a, b and c in
// [1, 2), d in [1, 2) times a power of two, of either sign. Where that is 2^(2p + 3) or more, or
// as small, one product is below a quarter of the other's last place, squared.
template <int p>
void EveryDifferenceOfProducts() {
  using T = TinyFloat<p>;
  constexpr double kUnit = rounding_epsilon<T>();
  std::vector<T> ones = T::NotNegative(1);
  ones.erase(ones.begin());
  Tried tried;
  for (int k = -2 * p - 3; k <= 2 * p + 3; ++k) {
    for (const T a : ones) {
      for (const T b : ones) {
        for (const T c : ones) {
          const KahanForm<T> form({T(), T()}, {c, b}, false);
          for (const T one : ones) {
            for (const double scale : {std::ldexp(1.0, k), -std::ldexp(1.0, k)}) {
              const T d(one * scale);
              const double exact = a * static_cast<double>(b) - c * static_cast<double>(d);
              tried.Add(std::fabs(form.At(a, d) - exact), 2 * kUnit * std::fabs(exact));
            }
          }
        }
      }
    }
  }
  tried.Report("every difference of products by Kahan's, 2u |ab - cd|", p);
  EXPECT_GT(tried.worst, 0.5);
}

// Jeannerod, Louvet, Muller 2013, Theorem 1.1, cited beside kKahanEdgeErrorMultiplier.
TEST(TinyFloats, KahansTwoUnitsHoldForAllNumbersOfThreeToSixBits) {
  EveryDifferenceOfProducts<3>();
  EveryDifferenceOfProducts<4>();
  EveryDifferenceOfProducts<5>();
  if (kOneCaseIn == 1) EveryDifferenceOfProducts<6>();
}

template <int p>
void QuotientsOfASum(int binades) {
  using T = TinyFloat<p>;
  const std::vector<T> all = T::NotNegative(binades);
  Tried exactly;
  for (const T e0 : all) {
    for (const T e1 : all) {
      for (const T e2 : all) {
        if (e0 == 0 && e1 == 0 && e2 == 0) continue;
        const std::array<T, 3> l = OverTheirSum<T>({e0, e1, e2});
        const double sum = double{l[0]} + double{l[1]} + double{l[2]};
        exactly.Add(std::fabs(sum - 1),
                    kNormalizedSumErrorMultiplier<T> * double{rounding_epsilon<T>()});
      }
    }
  }
  exactly.Report("barycentrics over their sum", p);
}

template <int p>
void LastOfOnes() {
  using T = TinyFloat<p>;
  Tried tried;
  std::vector<T> upto_one;  // down to 2^-6, and zero
  for (const T x : T::NotNegative(7)) upto_one.push_back(T(x / 64.0));
  std::erase_if(upto_one, [](T x) { return x > 1; });
  for (const T l0 : upto_one) {
    for (const T l1 : upto_one) {
      const T l2 = LastOfOne(T(1), l0, l1);
      if (l2 < 0) continue;
      tried.Add(std::fabs(double{l0} + double{l1} + double{l2} - 1), kOneMinusSumError<T>);
    }
  }
  tried.Report("one less the other two", p);
}

// The float sum of l0, l1 and (1 - l0) - l1 is 1 or the number below: never more than u away.
template <int p>
void FloatSumsOfOnes() {
  using T = TinyFloat<p>;
  Tried tried;
  std::vector<T> upto_one;  // down to 2^-(p + 3): what is less rounds away beside 1
  for (const T x : T::NotNegative(p + 4)) upto_one.push_back(T(std::ldexp(double{x}, -p - 3)));
  std::erase_if(upto_one, [](T x) { return x > 1; });
  for (const T l0 : upto_one) {
    for (const T l1 : upto_one) {
      const T l2 = LastOfOne(T(1), l0, l1);
      if (l2 < 0) continue;
      const double sum = (l0 + l1) + l2;
      EXPECT_LE(sum, 1);
      tried.Add(1 - sum, rounding_epsilon<T>());
    }
  }
  tried.Report("the float sum with one less the other two", p);
  EXPECT_EQ(tried.worst, 1);
}

TEST(TinyFloats, FloatSumsOfBarycentricsAreOneOrTheNumberBelow) {
  FloatSumsOfOnes<3>();
  FloatSumsOfOnes<4>();
  FloatSumsOfOnes<5>();
  FloatSumsOfOnes<6>();
  FloatSumsOfOnes<7>();
  FloatSumsOfOnes<8>();
}

// The same at 24 bits, for which docs/mathematics.md, 9, has the proof.
TEST(TinyFloats, FloatSumsOfBarycentricsInFloat32AreOneOrTheNumberBelow) {
  RandomValues random(52);
  int below = 0;
  for (int n = 0; n < Cases(2'000'000); ++n) {
    const float l0 = std::fabs(random.LogUniform<float>(-26, 0));
    const float left = 1 - l0;
    // Beside 0, one half and all of what is left, where the cases of the proof meet.
    const std::array<float, 3> around{std::fabs(random.LogUniform<float>(-26, 0)), left / 2, left};
    float l1 = around[static_cast<std::size_t>(random.Integer(0, 2))];
    l1 = MoveByUlps(l1, random.Integer(-4, 4));
    const float l2 = LastOfOne(1.0F, l0, l1);
    if (!(l1 >= 0 && l2 >= 0)) continue;
    const float sum = (l0 + l1) + l2;
    ASSERT_TRUE(sum == 1 || sum == 1 - 0x1p-24F) << l0 << ' ' << l1;
    below += sum < 1 ? 1 : 0;
  }
  EXPECT_GT(below, 0);
}

TEST(TinyFloats, BarycentricsSumToOneWithinTheirBounds) {
  QuotientsOfASum<3>(6);
  QuotientsOfASum<4>(5);
  QuotientsOfASum<5>(4);
  if (kOneCaseIn == 1) {
    QuotientsOfASum<6>(5);
    QuotientsOfASum<7>(5);
  }
  LastOfOnes<3>();
  LastOfOnes<4>();
  LastOfOnes<5>();
}

// (E / A) (A / m) against E / m.
template <int p>
void DistancesByBarycentrics(int binades) {
  using T = TinyFloat<p>;
  constexpr double kUnit = rounding_epsilon<T>();
  std::vector<T> all = T::NotNegative(binades);
  all.erase(all.begin());
  Tried tried;
  for (const T edge : all) {
    for (const T area : all) {
      for (const T measure : all) {
        const T distance = (edge / area) * (area / measure);
        // Both sides times the measure, so that no quotient is rounded.
        tried.Add(std::fabs(double{distance} * double{measure} - double{edge}),
                  kEdgeDistanceErrorMultiplier<T> * kUnit * double{edge});
      }
    }
  }
  tried.Report("a distance by a barycentric", p);
}

TEST(TinyFloats, DistancesByBarycentricsStayWithinTheirBound) {
  DistancesByBarycentrics<3>(2);
  DistancesByBarycentrics<4>(2);
  DistancesByBarycentrics<5>(2);
}

}  // namespace
}  // namespace rasterproof::reference
