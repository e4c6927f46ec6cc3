// The snap against its second definition: every rule, form, bit count and origin that a profile can
// name; and the snaps in integers that the fixed-point methods and the mutants have of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "core/profile_keys.h"
#include "core/snap.h"
#include "model/snap.h"
#include "reference/integer_form.h"
#include "subjects/mutants/placing.h"
#include "tests/model/hard_numbers.h"
#include "tests/model/second_definition.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr SnapRule kRules[] = {SnapRule::kNearestEven, SnapRule::kNearestAway, SnapRule::kHalfUp,
                               SnapRule::kFloor, SnapRule::kTruncate};
constexpr SnapForm kForms[] = {SnapForm::kCoordinate, SnapForm::kFloat32Difference,
                               SnapForm::kExactDifference};
constexpr int kBitsApart = kOneCaseIn > 1 ? 8 : 1;
constexpr int kOrigins = 256;           // a multiple of 1/256 in [0, 1)
constexpr double kExactBelow = 0x1p34;  // of differences

// Ties, quarters and points of the grid about `origin`, and the doubles and floats beside them.
std::vector<double> NearTheGrid(int bits, double origin, const std::vector<double>& wholes) {
  const double step = std::ldexp(1.0, -bits);
  std::vector<double> all;
  for (const double whole : wholes) {
    for (const int quarter : {0, 1, 2, 3}) {
      const double x = whole + origin + quarter * step / 4;
      for (const double beside : second::AndNeighbours(x)) all.push_back(beside);
    }
  }
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

std::string Text(double x, const Snap& snap) {
  std::string text(64, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%a", x)));
  return text + ", " + std::to_string(snap.bits) + " bits, " +
         std::string(SnapRuleName(snap.rule)) + ", " + std::string(SnapFormName(snap.form)) +
         ", origin " + std::to_string(snap.origin);
}

bool IsNegativeZero(double x) { return x == 0 && std::signbit(x); }

// Of a difference: within the domain in which it is stated.
void ExpectSnapped(double x, const Snap& snap) {
  if (snap.form != SnapForm::kCoordinate && std::fabs(x) >= kExactBelow) return;
  const double snapped = SnapCoordinate(x, snap);
  ASSERT_EQ(mpq_class(snapped), second::Snapped(mpq_class(x), snap)) << Text(x, snap);
  ASSERT_FALSE(IsNegativeZero(snapped)) << Text(x, snap);
}

template <class Function>
void ForEverySnap(const std::vector<double>& xs, int bits, double origin, Function function) {
  for (const SnapRule rule : kRules) {
    for (const SnapForm form : kForms) {
      if (form == SnapForm::kCoordinate && origin != 0) continue;
      for (const double x : xs) {
        function(x, Snap{bits, rule, form, origin});
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(SnapByRationals, IsSnapCoordinateForEveryRuleFormBitCountAndOrigin) {
  for (int bits = 0; bits <= kMaxSubpixelBits; bits += kBitsApart) {
    for (int k = 0; k < kOrigins; k += kBitsApart) {
      const double origin = k / double{kOrigins};
      const std::vector<double> xs = NearTheGrid(bits, origin, {-1.0 + k % 2});
      ForEverySnap(xs, bits, origin, ExpectSnapped);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SnapByRationals, IsSnapCoordinateFarOffAndAtTheEndsOfTheRange) {
  for (int bits = 0; bits <= kMaxSubpixelBits; bits += kBitsApart) {
    for (const double origin : {0.0, 0.5, 1.0 / 256, 255.0 / 256}) {
      std::vector<double> xs = NearTheGrid(
          bits, origin,
          {1, 2, 3, -2, -3, 2047, -2048, 0x1p15, 1 - 0x1p15, 0x1p23, -0x1p24, 1 - 0x1p34});
      for (const double x : second::EndsOfTheRange()) xs.push_back(x);
      ForEverySnap(xs, bits, origin, ExpectSnapped);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SnapByRationals, IsTheSnapOfTheMutants) {
  constexpr double kDrawnBelow = 0x1p41;
  const auto expect_snapped = [](double x, const Snap& snap) {
    const bool is_coordinate = snap.form == SnapForm::kCoordinate;
    if (std::fabs(x) >= (is_coordinate ? kDrawnBelow : kExactBelow)) return;
    if (snap.form == SnapForm::kFloat32Difference && double{static_cast<float>(x)} != x) return;
    const double snapped = subjects::mutants::SnapToGrid(x, snap);
    ASSERT_EQ(mpq_class(snapped), second::Snapped(mpq_class(x), snap)) << Text(x, snap);
    ASSERT_FALSE(IsNegativeZero(snapped)) << Text(x, snap);
  };
  for (int bits = 0; bits <= kMaxSubpixelBits; bits += kBitsApart) {
    for (const double origin : {0.0, 0.5, 1.0 / 256, 255.0 / 256}) {
      std::vector<double> xs = NearTheGrid(bits, origin, {-1, 0, 1, -2, 2047, -0x1p15, 0x1p24});
      for (const double x : second::EndsOfTheRange()) xs.push_back(x);
      ForEverySnap(xs, bits, origin, expect_snapped);
      if (HasFatalFailure()) return;
    }
  }
}

template <class I, int kBits>
void ExpectSnapOfTheForm() {
  std::vector<double> xs = NearTheGrid(kBits, 0, {-1, 0, 1, -2, 2047, -0x1p15, 0x1p24, 0x1p43});
  for (const double x : second::EndsOfTheRange()) xs.push_back(x);
  for (const double x : xs) {
    const Snap snap{kBits};
    const Point2 snapped = reference::IntegerForm<I, kBits>::Snapped({x, -x});
    ASSERT_EQ(mpq_class(snapped.x), second::Snapped(mpq_class(x), snap)) << Text(x, snap);
    ASSERT_EQ(mpq_class(snapped.y), second::Snapped(mpq_class(-x), snap)) << Text(-x, snap);
    ASSERT_FALSE(IsNegativeZero(snapped.x) || IsNegativeZero(snapped.y)) << Text(x, snap);
  }
  const Point2 neither = reference::IntegerForm<I, kBits>::Snapped(
      {HUGE_VAL, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(neither.x, HUGE_VAL);
  EXPECT_TRUE(std::isnan(neither.y));
}

TEST(SnapByRationals, IsTheSnapOfTheFixedPointMethods) {
  ExpectSnapOfTheForm<std::int32_t, 4>();
  ExpectSnapOfTheForm<std::int64_t, 8>();
}

TEST(GridPointsByRationals, AreThoseWithinTheToleranceAndTheSnapsOwn) {
  std::set<std::size_t> sizes;
  for (int bits = 0; bits <= kMaxSubpixelBits; bits += kBitsApart) {
    for (const double origin : {0.0, 0.5, 255.0 / 256}) {
      const std::vector<double> xs = NearTheGrid(bits, origin, {-1, 0, 0x1p20, 1 - 0x1p34});
      for (const double tolerance : {0.0, 0x1p-30, 0.25, 0.6, 1.0}) {
        ForEverySnap(xs, bits, origin, [&](double x, const Snap& snap) {
          if (std::fabs(x) >= kExactBelow) return;
          const std::vector<double> points = GridPointsWithin(x, snap, tolerance);
          sizes.insert(points.size());
          const std::vector<mpq_class> expected = second::GridPoints(mpq_class(x), snap, tolerance);
          ASSERT_EQ(std::vector<mpq_class>(points.begin(), points.end()), expected)
              << Text(x, snap) << ", tolerance " << tolerance;
        });
        if (HasFatalFailure()) return;
      }
    }
  }
  // Four where float32 has taken the snap's own far from x.
  EXPECT_EQ(sizes, (std::set<std::size_t>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace rasterproof
