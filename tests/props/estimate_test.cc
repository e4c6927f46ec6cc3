// Estimates lie within their errors, and what they decide is what exact rationals decide.
#include "props/judging/values/estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "core/evaluators.h"
#include "core/vertex.h"
#include "exact/attributes.h"
#include "exact/rational.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/interpolation_queries.h"
#include "props/judging/values/wireframe_queries.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A number both ways: by estimates, and exactly.
struct Both {
  Estimate estimate;
  Rational exact;
};

Both operator+(const Both& x, const Both& y) {
  return {x.estimate + y.estimate, x.exact + y.exact};
}
Both operator-(const Both& x, const Both& y) {
  return {x.estimate - y.estimate, x.exact - y.exact};
}
Both operator*(const Both& x, const Both& y) {
  return {x.estimate * y.estimate, x.exact * y.exact};
}
Both operator/(const Both& x, const Both& y) {
  return {x.estimate / y.estimate, x.exact / y.exact};
}

// Whether the estimate's error is finite, and then holds. `ratio`: the largest of what estimates
// with an error were off and that error.
bool Holds(const Both& x, double& ratio) {
  if (!std::isfinite(x.estimate.error())) return false;
  const Rational off = (Rational(x.estimate.high()) + x.estimate.low() - x.exact).Abs();
  EXPECT_LE(off, Rational(x.estimate.error())) << x.exact.ToDouble();
  if (x.estimate.error() > 0) {
    ratio = std::max(ratio, (off / Rational(x.estimate.error())).ToDouble());
  }
  EXPECT_EQ(x.estimate.high() + x.estimate.low(), x.estimate.high());
  return true;
}

class Numbers {
 public:
  // Of full length, or few bits; of any exponent up to the limit.
  double Double(int exponent) {
    const auto bits = static_cast<std::int64_t>(random_());
    const double mantissa =
        random_() % 3 == 0 ? static_cast<double>(bits >> 60) : static_cast<double>(bits);
    const auto range = static_cast<std::uint64_t>(2 * exponent + 1);
    return std::ldexp(mantissa, static_cast<int>(Below(range)) - exponent - 62);
  }
  Both Exact(int exponent) {
    const double x = Double(exponent);
    return {Estimate(x), x};
  }
  // A sum, product or quotient of others, so that it has a low part and an error.
  Both Any(int exponent) {
    const Both x = Exact(exponent);
    const Both y = Exact(exponent);
    switch (random_() % 5) {
      case 0:
        return x;
      case 1:
        return x + y;
      case 2:
        return x * y;
      case 3:
        return x * y - x * Both{Estimate(y.estimate.high()), Rational(y.estimate.high())};
      default:
        return y.exact.Sign() == 0 ? x : x / y;
    }
  }
  std::uint64_t Below(std::uint64_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_{1};
};

TEST(Estimate, IsWithinItsErrorAfterEveryOperation) {
  Numbers numbers;
  double given = 0;
  double of_sums = 0;
  double of_products = 0;
  double of_quotients = 0;
  for (const int exponent : {2, 30, 440, 1000}) {
    int finite = 0;
    constexpr int kPairs = 4000;
    for (int k = 0; k < kPairs; ++k) {
      const Both x = numbers.Any(exponent);
      const Both y = numbers.Below(4) == 0 ? x : numbers.Any(exponent);
      if (!Holds(x, given) || !Holds(y, given)) continue;
      finite += Holds(x + y, of_sums) + Holds(x - y, of_sums) + Holds(x * y, of_products);
      if (y.exact.Sign() != 0) finite += Holds(x / y, of_quotients);
    }
    EXPECT_GT(finite, exponent > 100 ? kPairs / 20 : 3 * kPairs) << exponent;
  }
  std::printf("largest error over its bound: sums %.4f, products %.4f, quotients %.4f\n", of_sums,
              of_products, of_quotients);
}

TEST(Estimate, IsSmallInErrorOrHasNone) {
  const Estimate third = Estimate(1) / Estimate(3);
  EXPECT_LT(third.error(), 0x1p-100);
  EXPECT_GT(third.error(), 0);
  EXPECT_EQ((Estimate(6) / Estimate(3)).error(), 0);
  EXPECT_EQ((Estimate(0x1p52 + 1) * Estimate(0x1p52 + 3)).error(), 0);
  EXPECT_EQ((Estimate(1) + Estimate(0x1p-1074)).error(), 0);
  EXPECT_EQ((Estimate(0) / third).error(), 0);
  EXPECT_EQ(EstimatedEdge({0.5, 0.5}, {2.5, 2.5}, {1.5, 1.5}).error(), 0);
}

TEST(Estimate, DecidesNothingOfWhatCouldUnderflowOverflowOrVanish) {
  const Estimate third = Estimate(1) / Estimate(3);
  const Estimate around_zero = third * Estimate(3) - Estimate(1);
  for (const Estimate& e :
       {Estimate(0x1p-600) * Estimate(0x1p-600), Estimate(0x1p600) * Estimate(0x1p600),
        Estimate(0x1p1023) + Estimate(0x1p1023), third / around_zero, Estimate(1) / Estimate(0),
        Estimate(0) * (Estimate(1) / Estimate(0)), Estimate(0x1p-600) / Estimate(0x1p600)}) {
    EXPECT_FALSE(std::isfinite(e.error()));
    EXPECT_FALSE(CompareWithEstimate(e.high(), e, 0x1p1023));
  }
}

// Plants observed values beside the exact one, and bounds beside their distance from it: where an
// estimate decides, exact rationals decide the same. Returns how many bounds it decided.
int Decided(Numbers& numbers, const Estimate& estimate, const Rational& exact, int precision) {
  int decided = 0;
  for (int k = 0; k < 4; ++k) {
    const double nearest = exact.ToDouble();
    const double observed =
        nearest + std::ldexp(nearest, -precision) * static_cast<double>(numbers.Below(9));
    if (!std::isfinite(observed)) continue;
    const double distance = (Rational(observed) - exact).Abs().ToDoubleUp();
    for (const double bound :
         {std::nextafter(distance, 0), distance, std::nextafter(distance, kInfinity),
          distance * (1 + 0x1p-40), distance * (1 - 0x1p-40), 2 * distance}) {
      const std::optional<Distance> near = CompareWithEstimate(observed, estimate, bound);
      if (!near) continue;
      const Distance decided_exactly = CompareWithExact(observed, exact, bound);
      EXPECT_TRUE(near->within && decided_exactly.within) << observed << " " << bound;
      EXPECT_NEAR(near->ratio, decided_exactly.ratio,
                  0x1p-40 + (bound > 0 ? estimate.error() / bound : 0));
      ++decided;
    }
  }
  return decided;
}

// A sample and a triangle of float32 values: on a grid, or of full length.
BarycentricQuery QueryOf(Numbers& numbers) {
  const bool on_grid = numbers.Below(2) == 0;
  const auto coordinate = [&] {
    return on_grid ? static_cast<double>(numbers.Below(64)) / 4
                   : static_cast<double>(static_cast<float>(numbers.Double(5)));
  };
  const auto point = [&] { return Point2{coordinate(), coordinate()}; };
  return {0, {point(), point(), point()}, {0, 0, 0, point()}, true};
}

TEST(CompareWithEstimate, NeverPassesWhatIsOneUlpBeyondItsBound) {
  Numbers numbers;
  int decided = 0;
  int asked = 0;
  for (int k = 0; k < 1500; ++k) {
    const BarycentricQuery q = QueryOf(numbers);
    const auto lambda = exact::Barycentrics(q.v, q.place.at);
    if (!lambda) continue;
    const std::array<Estimate, 3> near = EstimatedBarycentrics(q.v, q.place.at);
    const InterpolationQuery values{
        q, {Corner{q.v[0], 1}, Corner{q.v[1], 4}, Corner{q.v[2], 0.5}}, {0.25, 1, 0.625}};
    for (const int precision : {23, 52}) {
      ++asked;
      for (std::size_t i = 0; i < 3; ++i) {
        decided += Decided(numbers, near[i], (*lambda)[i], precision);
      }
      for (const InterpolationForm form :
           {InterpolationForm::kBarycentrics, InterpolationForm::kPerspective}) {
        const auto exact = ExactInterpolation(form, values);
        if (exact) {
          decided += Decided(numbers, EstimatedInterpolation(form, values), *exact, precision);
        }
      }
    }
  }
  EXPECT_GT(decided, 30 * asked);
}

TEST(Nearest, OfAnEstimateIsTheExactOnesOrOpen) {
  Numbers numbers;
  int settled = 0;
  for (int k = 0; k < 5000; ++k) {
    const Both x = numbers.Any(30);
    const Both square = numbers.Below(2) == 0 ? x * x : x;
    const double nearest = Nearest(square.estimate);
    if (std::isnan(nearest)) continue;
    ++settled;
    EXPECT_EQ(nearest, Nearest(square.exact));
    const double root = RoundedRoot(square.estimate);
    if (!std::isnan(root)) {
      EXPECT_EQ(root, RoundedRoot(square.exact));
    }
  }
  EXPECT_GT(settled, 4900);
  const Estimate midpoint = Estimate(1) + Estimate(0x1p-53) + Estimate(0x1p-106) / Estimate(3);
  EXPECT_TRUE(std::isnan(Nearest(midpoint * (Estimate(1) / Estimate(3)) * Estimate(3))));
}

TEST(IsSurelyWithin, NeverPassesWhatIsOneUlpBeyondItsBound) {
  Numbers numbers;
  int passed = 0;
  for (int k = 0; k < 2000; ++k) {
    const Rational square = numbers.Any(20).exact.Abs();
    const double root = RoundedRoot(square);
    const double observed = root + std::ldexp(root, -52) * static_cast<double>(numbers.Below(40));
    const double off = std::fabs(observed - root);
    for (int ulps = -4; ulps <= 24; ++ulps) {
      const double bound = off + std::ldexp(off + root, -53) * ulps;
      if (bound < 0 || !IsSurelyWithin(observed, root, bound)) continue;
      ++passed;
      EXPECT_TRUE(IsWithin(observed, square, bound)) << root << " " << observed << " " << bound;
    }
  }
  EXPECT_GT(passed, 20000);
}

}  // namespace
}  // namespace rasterproof::props
