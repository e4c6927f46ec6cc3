// How near the filter, the guessed crossings and the running bounds of space come to being broken:
// searches on bit patterns, with the oracle's rationals for the truth. The limit is the header's
// constant; the floor says that the search bites.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "library/exact_sign.h"
#include "library/row_crossing.h"
#include "tests/climb.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;

/// Draws log-uniform magnitudes 2^[low, high) of either sign.
auto LogUniformDraw(int low, int high) {
  return [=](RandomValues& random) { return random.LogUniform<double>(low, high); };
}

/// Prints what a search found and holds it against the bound and the floor.
void ReportShare(const char* what, double worst, double floor) {
  std::printf("[ MEASURED ] %-44s error / bound %.3f\n", what, worst);
  EXPECT_LE(worst, 1) << what;
  EXPECT_GT(worst, floor / (kOneCaseIn > 1 ? 8 : 1)) << what;
}

/// error / bound, checked exactly to be at most 1; 0 where no bound is stated.
double ShareOf(const Rational& error, double bound) {
  if (!std::isfinite(bound)) return 0;
  EXPECT_LE(error.Abs(), Rational(bound));
  if (bound == 0) return 0;
  return (error.Abs() / bound).ToDouble();
}

/// What the filter is sure of has E's sign; `rounded`: whether the last rounding counts as well.
double FilterShare(const std::array<double, 6>& c, bool rounded) {
  const Point2 a{c[0], c[1]};
  const Point2 b{c[2], c[3]};
  const Point2 p{c[4], c[5]};
  const double p1 = (p.x - a.x) * (b.y - a.y);
  const double p2 = (p.y - a.y) * (b.x - a.x);
  const Rational exact = exact::EdgeValue(a, b, p);
  const library::FilteredEdge filtered = library::FilterEdge(a, b, p);
  EXPECT_TRUE(!filtered.certain || (filtered.value > 0 ? 1 : -1) == exact.Sign());
  if (rounded)
    return ((Rational(filtered.value) - exact).Abs() / library::FilterBound(p1, p2)).ToDouble();
  return ShareOf(Rational(p1) - p2 - exact, library::FilterBound(p1, p2));
}

TEST(MeasuredReferenceBounds, NoSearchExceedsTheFilterOfAnEdge) {
  ReportShare("filter of an edge",
              Largest<6>({.seed = 71, .evaluations = Cases(20000)}, LogUniformDraw(-1, 3),
                         [](const auto& c) { return FilterShare(c, false); }),
              0.6);
  ReportShare("filter of an edge, products underflow",
              Largest<6>({.seed = 72, .evaluations = Cases(10000)}, LogUniformDraw(-560, -530),
                         [](const auto& c) { return FilterShare(c, false); }),
              0.2);
}

TEST(MeasuredReferenceBounds, TheFilterBoundsTheProductsAndNotTheirRoundedDifference) {
  const double worst = Largest<6>({.seed = 73, .evaluations = 4000}, LogUniformDraw(-1, 3),
                                  [](const auto& c) { return FilterShare(c, true); });
  EXPECT_GT(worst, 1) << "the last rounding is a fourth, and a sign does not need it";
  EXPECT_LE(worst, 4.0 / 3);
}

TEST(MeasuredReferenceBounds, TheConstantsAreTheNumbersThatTheScriptsProve) {
  // proofs/edge_filter.g, and row_crossing.g: 13u (2^28 + 1).
  EXPECT_EQ(library::kFilterErrorMultiplier, std::ldexp(27021597764222992.0, -106));
  EXPECT_LT(std::ldexp(13, -53) * (library::RowCrossing::kGuessDomain + 1),
            library::RowCrossing::kCrossingError / 2);
}

/// x of the ends, y of the ends, and how far down the row lies: what At() makes of the guess.
double CrossingShare(const std::array<double, 5>& c) {
  const Point2 upper{c[0], std::min(c[2], c[3])};
  const Point2 lower{c[1], std::max(c[2], c[3])};
  const double far = std::fabs(c[4]) - std::floor(std::fabs(c[4]));
  const double row = std::floor(upper.y * (1 - far) + lower.y * far);
  if (!(row >= 0 && row < 65536 && row + 0.5 >= upper.y && row + 0.5 < lower.y)) return 0;
  if (std::max(std::fabs(upper.x), std::fabs(lower.x)) > library::RowCrossing::kGuessDomain)
    return 0;
  const double guess = library::RowCrossing(upper, lower).Guess(static_cast<int>(row));
  constexpr double kAdded = 0.5 + library::RowCrossing::kCrossingError;
  const Rational slope = (Rational(lower.x) - upper.x) / (Rational(lower.y) - upper.y);
  const Rational truth = Rational(upper.x) + (Rational(row + 0.5) - upper.y) * slope;
  return std::max(
      ShareOf(Rational(guess) - truth, library::RowCrossing::kCrossingError),
      ShareOf(Rational(guess + kAdded) - truth - kAdded, library::RowCrossing::kCrossingError));
}

TEST(MeasuredReferenceBounds, NoSearchExceedsTheErrorOfAGuessedCrossing) {
  const auto draw = [](RandomValues& random) {
    // Ends at the domain's border in x, of any height.
    return random.Coin() ? random.LogUniform<double>(26, 28) : random.LogUniform<double>(3, 16);
  };
  ReportShare("guessed crossing",
              Largest<5>({.seed = 74, .evaluations = Cases(40000)}, draw, CrossingShare), 0.1);
}

}  // namespace
}  // namespace rasterproof::reference
