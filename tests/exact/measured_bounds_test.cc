// How near the bounds of exact/ come to being broken: searches on bit patterns, with GMP's
// rationals for the truth. The limit is the header's constant; the floor says that the search
// bites.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/filters.h"
#include "exact/homogeneous_crossing.h"
#include "exact/row_edge.h"
#include "exact/wide_integer.h"
#include "tests/climb.h"
#include "tests/exact/naive.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::exact {
namespace {

using reference::RandomValues;

/// Draws log-uniform magnitudes 2^[low, high) of either sign.
auto LogUniform(int low, int high) {
  return [=](RandomValues& random) { return random.LogUniform<double>(low, high); };
}

/// Prints what a search found and holds it against the bound and the floor.
void Report(const char* what, double worst, double floor) {
  std::printf("[ MEASURED ] %-44s error / bound %.3f\n", what, worst);
  EXPECT_LE(worst, 1) << what;
  EXPECT_GT(worst, floor / (kOneCaseIn > 1 ? 8 : 1)) << what;
}

/// error / bound, checked exactly to be at most 1.
double Share(const mpq_class& error, double bound) {
  if (!std::isfinite(bound)) return 0;
  EXPECT_TRUE(abs(error) <= mpq_class(bound));
  if (bound == 0) return 0;
  return mpq_class(abs(error) / mpq_class(bound)).get_d();
}

/// Checks that a sign that the filter states is the exact one.
void ExpectCertainSignOf(const FilteredValue& filtered, const mpq_class& exact) {
  const int sign = filtered.CertainSign();
  EXPECT_TRUE(sign == 0 || sign == sgn(exact));
}

double EdgeShare(const std::array<double, 6>& c) {
  const Point2 a{c[0], c[1]};
  const Point2 b{c[2], c[3]};
  const Point2 p{c[4], c[5]};
  const EdgeProducts e(a, b, p);
  const mpq_class exact = NaiveEdge(NaiveAt(a), NaiveAt(b), NaiveAt(p));
  ExpectCertainSignOf(e.Filter(), exact);
  return Share(mpq_class(e.l) - mpq_class(e.r) - exact, e.Filter().error);
}

TEST(MeasuredBounds, NoSearchExceedsTheEdgeFilter) {
  Report("edge filter",
         Largest<6>({.seed = 61, .evaluations = Cases(60000)}, LogUniform(-1, 3), EdgeShare), 0.7);
}

TEST(MeasuredBounds, NoSearchExceedsTheEdgeFilterWhereProductsUnderflow) {
  Report("edge filter, products underflow",
         Largest<6>({.seed = 62, .evaluations = Cases(30000)}, LogUniform(-560, -530), EdgeShare),
         0.2);
}

/// The first row is 2^first times what was drawn.
double DeterminantShare(const std::array<double, 9>& c, int first) {
  Rows3 rows;
  for (unsigned k = 0; k < 9; ++k) rows[k / 3][k % 3] = c[k];
  for (double& x : rows[0]) x = std::ldexp(x, first);
  const auto row = [&](unsigned i) { return NaiveRow{rows[i][0], rows[i][1], rows[i][2]}; };
  const mpq_class exact = NaiveDeterminant(row(0), row(1), row(2));
  const FilteredValue filtered = FilterDeterminant(rows);
  ExpectCertainSignOf(filtered, exact);
  return Share(mpq_class(filtered.value) - exact, filtered.error);
}

TEST(MeasuredBounds, NoSearchExceedsTheDeterminantFilter) {
  Report("determinant filter",
         Largest<9>({.seed = 63, .evaluations = Cases(60000)}, LogUniform(-1, 2),
                    [](const auto& c) { return DeterminantShare(c, 0); }),
         0.3);
}

TEST(MeasuredBounds, NoSearchExceedsTheDeterminantFilterWhereMinorsUnderflow) {
  // The first row is large: what its minors lose counts.
  Report("determinant filter, minors underflow",
         Largest<9>({.seed = 64, .evaluations = Cases(30000)}, LogUniform(-545, -536),
                    [](const auto& c) { return DeterminantShare(c, 600); }),
         0.15);
  Report("determinant filter, terms underflow",
         Largest<9>({.seed = 65, .evaluations = Cases(30000)}, LogUniform(-362, -357),
                    [](const auto& c) { return DeterminantShare(c, 0); }),
         0.3);
}

/// The share of the guess's error that is needed for low < truth < high, both as the caller rounds
/// them.
double NeededShare(const Guess& guess, const mpq_class& truth) {
  if (!std::isfinite(guess.error)) return 0;
  const mpq_class below = truth - mpq_class(guess.at - guess.error);
  const mpq_class above = mpq_class(guess.at + guess.error) - truth;
  const mpq_class left = std::min(below, above);
  EXPECT_GT(sgn(left), 0);
  return 1 - mpq_class(left / mpq_class(guess.error)).get_d();
}

/// x of the ends, y of the ends, and how far down the row lies.
double RowShare(const std::array<double, 5>& c) {
  const Point2 upper{c[0], std::min(c[2], c[3])};
  const Point2 lower{c[1], std::max(c[2], c[3])};
  const double far = std::fabs(c[4]) - std::floor(std::fabs(c[4]));
  const double y = std::round((upper.y * (1 - far) + lower.y * far) * 0x1p20) * 0x1p-20;
  if (!(upper.y < lower.y && y >= upper.y && y <= lower.y && std::fabs(y) <= 0x1p17)) return 0;
  constexpr double kOffset = 0.5;
  const mpq_class slope =
      (mpq_class(lower.x) - mpq_class(upper.x)) / (mpq_class(lower.y) - mpq_class(upper.y));
  const mpq_class truth =
      mpq_class(upper.x) + (mpq_class(y) - mpq_class(upper.y)) * slope - mpq_class(kOffset);
  return NeededShare(RowEdge(upper, lower).At(y, kOffset), truth);
}

TEST(MeasuredBounds, NoSearchExceedsTheErrorOfARowsCrossing) {
  Report("row crossing",
         Largest<5>({.seed = 66, .evaluations = Cases(80000)}, LogUniform(0, 12), RowShare), 0.35);
}

TEST(MeasuredBounds, NoSearchExceedsTheErrorOfARowsCrossingWhereTheSlopeUnderflows) {
  // Ends 2^1023 away in y, and a step in x whose slope is half the least subnormal.
  const auto share = [](const std::array<double, 2>& c) {
    const Point2 upper{0, -std::fabs(c[0]) * 0x1p1020};
    const Point2 lower{c[1] * 0x1p-55, std::fabs(c[0]) * 0x1p1020};
    const mpq_class truth = mpq_class(lower.x) / 2;
    return NeededShare(RowEdge(upper, lower).At(0, 0), truth);
  };
  Report("row crossing, the slope underflows",
         Largest<2>({.seed = 67, .evaluations = Cases(20000)}, LogUniform(0, 4), share), 0.07);
}

/// The vertices' x, y and w, and the row.
double HomogeneousShare(const std::array<double, 7>& c) {
  const Vertex vi{c[0], c[1], 0, c[2]};
  const Vertex vj{c[3], c[4], 0, c[5]};
  const double y = std::round(c[6] * 0x1p20) * 0x1p-20;
  constexpr double kOffset = 0.5;
  const auto minor = [](double a, double b, double d, double e) {
    return mpq_class(mpq_class(a) * mpq_class(b) - mpq_class(d) * mpq_class(e));
  };
  const mpq_class nx = minor(vj.y, vi.w, vj.w, vi.y);
  if (sgn(nx) == 0) return 0;
  const mpq_class ny = minor(vj.w, vi.x, vj.x, vi.w);
  const mpq_class nw = minor(vj.x, vi.y, vj.y, vi.x);
  const mpq_class truth = -(ny * mpq_class(y) + nw) / nx - mpq_class(kOffset);
  return NeededShare(HomogeneousCrossing(vi, vj).At(y, kOffset), truth);
}

TEST(MeasuredBounds, NoSearchExceedsTheErrorOfAHomogeneousCrossing) {
  Report("homogeneous crossing",
         Largest<7>({.seed = 68, .evaluations = Cases(60000)}, LogUniform(-1, 4), HomogeneousShare),
         0.2);
}

TEST(MeasuredBounds, TheConstantsAreTheNumbersThatTheScriptsProve) {
  // reference/proofs/edge_filter.g, determinant_filter.g, row_crossing.g, homogeneous_crossing.g.
  EXPECT_EQ(kEdgeErrorMultiplier, std::ldexp(27021597764222992.0, -106));
  EXPECT_EQ(kDeterminantErrorMultiplier, std::ldexp(8, -53));
  EXPECT_EQ(kCrossingErrorMultiplier, std::ldexp(16, -53));
  EXPECT_EQ(kHomogeneousCrossingErrorMultiplier, std::ldexp(16, -53));
}

TEST(MeasuredBounds, TheWidestDeterminantTakesEveryLimb) {
  // Columns of +-max and the least subnormal: their unit is 2^-1074. |det| is 4 max^3, the largest
  // that entries of one size can have (Hadamard).
  constexpr double kMax = std::numeric_limits<double>::max();
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const int unit = CommonUnit({kMax, -kMax, kLeast});
  const WideInteger m(kMax, unit);
  const WideInteger two_squares = m * m - (WideInteger() - m) * m;
  const WideInteger widest = m * two_squares + m * two_squares;
  std::printf("[ MEASURED ] widest determinant: %d of %d limbs\n", widest.Limbs(),
              WideInteger::kLimbs);
  EXPECT_EQ(widest.Sign(), 1);
  EXPECT_EQ(widest.Limbs(), WideInteger::kLimbs);
}

}  // namespace
}  // namespace rasterproof::exact
