#include "exact/edge.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <thread>

#include "core/tie_rule.h"
#include "core/vertex.h"
#include "tests/exact/families.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMaxFloat = std::numeric_limits<float>::max();

struct KnownSign {
  const char* what;
  Point2 a, b, p;
  int sign;
};

// Worked by hand.
constexpr KnownSign kKnown[]{
    {"a point above an edge to the right, as seen on screen", {0, 0}, {1, 0}, {0, -1}, +1},
    {"a point below it", {0, 0}, {1, 0}, {0, 1}, -1},
    {"a point on it", {0, 0}, {4, 2}, {2, 1}, 0},
    {"products that underflow", {0, 0}, {1e-200, 1e-200}, {2e-200, 3e-200}, -1},
    {"products that underflow, the other way", {0, 0}, {2e-200, 3e-200}, {1e-200, 1e-200}, +1},
    {"products that overflow", {0, 0}, {1e200, 1e200}, {2e200, 3e200}, -1},
    {"the smallest triangle there is", {0, 0}, {kLeast, 0}, {0, kLeast}, -1},
    {"the largest triangle there is", {-kMax, -kMax}, {kMax, -kMax}, {-kMax, kMax}, -1},
    {"a diagonal from end to end", {-kMax, -kMax}, {kMax, kMax}, {0, 0}, 0},
    {"and a step of 2^-1074 off it", {-kMax, -kMax}, {kMax, kMax}, {kLeast, 0}, +1},
    {"both ends of the exponent range", {-kMax, -kLeast}, {kMax, kLeast}, {0, 0}, 0},
    {"both ends, one step off", {-kMax, -kLeast}, {kMax, kLeast}, {0, kLeast}, -1},
    {"the largest float32", {-kMaxFloat, 0}, {kMaxFloat, 0x1p-149}, {0, 0x1p-150}, 0},
    {"the largest float32, half a step less", {-kMaxFloat, 0}, {kMaxFloat, 0x1p-149}, {0, 0}, +1},
    {"across the border of the subnormals",
     {0, 0},
     {0x1p-1022, 0x1p-1023},
     {0x1p-1021, 0x1p-1022},
     0},
    {"an edge of no length", {3, 4}, {3, 4}, {7, -2}, 0},
    {"signed zeros", {-0.0, 0.0}, {0.0, -0.0}, {1, 1}, 0},
    {"1e30 beside 1e-30", {-1e30, -1e30}, {1e30, 1e30}, {1e-30, 0}, +1},
};

TEST(EdgeSign, EveryDeciderKnowsTheHandWorkedCases) {
  for (const KnownSign& known : kKnown) {
    for (const Decider decider : kDeciders) {
      EXPECT_EQ(EdgeSign(known.a, known.b, known.p, decider), known.sign)
          << known.what << ", " << DeciderName(decider);
    }
    EXPECT_EQ(NaiveEdgeSign(known.a, known.b, known.p), known.sign) << known.what << ", naive";
    EXPECT_EQ(EdgeValue(known.a, known.b, known.p).Sign(), known.sign) << known.what << ", value";
  }
}

TEST(EdgeSign, EveryDeciderAgreesWithTheNaiveOneInEveryFamily) {
  for (int f = 0; f < kFamilies; ++f) {
    Draw draw(100 + static_cast<unsigned>(f));
    for (int k = 0; k < 400; ++k) {
      const auto [a, b, p] = draw.EdgeAndPoint(static_cast<Family>(f));
      const int truth = NaiveEdgeSign(a, b, p);
      for (const Decider decider : kDeciders) {
        ASSERT_EQ(EdgeSign(a, b, p, decider), truth)
            << FamilyName(static_cast<Family>(f)) << " " << k << ", " << DeciderName(decider);
      }
    }
  }
}

TEST(EdgeSign, TurnsOverWithTheEdgeAndWithAnyTwoPoints) {
  Draw draw(7);
  for (int k = 0; k < 4000; ++k) {
    const auto [a, b, p] = draw.EdgeAndPoint(static_cast<Family>(k % kFamilies));
    for (const Decider decider : kDeciders) {
      const int sign = EdgeSign(a, b, p, decider);
      ASSERT_EQ(EdgeSign(b, a, p, decider), -sign);
      ASSERT_EQ(EdgeSign(a, p, b, decider), -sign);
      ASSERT_EQ(EdgeSign(b, p, a, decider), sign);
    }
    ASSERT_EQ(EdgeSign(a, b, a), 0);
    ASSERT_EQ(EdgeSign(a, b, b), 0);
  }
}

TEST(EdgeSign, ReachesEveryTierAndCountsEachDecisionOnce) {
  const TierScope scope;
  EXPECT_EQ(EdgeSign({0, 0}, {3, 0}, {1, 5}), -1);
  EXPECT_EQ(scope.Counts().filter, 1U) << "far from the edge";
  EXPECT_EQ(EdgeSign({0, 0}, {4, 2}, {2, 1}), 0);
  EXPECT_EQ(scope.Counts().stable, 1U) << "on the edge, exact differences";
  EXPECT_EQ(EdgeSign({0x1p-60, 0}, {3, 3}, {1, 1}), -1);
  EXPECT_EQ(scope.Counts().exact, 1U) << "a difference that is rounded";
  EXPECT_EQ(EdgeSign({0, 0}, {1e-200, 1e-200}, {2e-200, 3e-200}), -1);
  EXPECT_EQ(scope.Counts().exact, 2U) << "products that underflow";
  EXPECT_NE(ShiftedEdgeSign({0, 0}, {4, 2}, {2, 1}, kTopLeft), 0);
  EXPECT_EQ(scope.Counts().symbolic, 1U) << "a tie";
  const TierCounts t = scope.Counts();
  EXPECT_EQ(t.filter + t.stable + t.exact + t.symbolic, 5U);
}

TEST(TierScope, SeesWhatItsOwnThreadDecidesWhileItLives) {
  const TierScope outer;
  EdgeSign({0, 0}, {3, 0}, {1, 5});
  {
    const TierScope inner;
    EXPECT_EQ(inner.Counts(), TierCounts{}) << "what was decided before is another call's";
    EdgeSign({0, 0}, {3, 0}, {1, 5});
    std::thread([] { EdgeSign({0, 0}, {3, 0}, {1, 5}); }).join();
    EXPECT_EQ(inner.Counts().filter, 1U);
    CreditTiers({0, 2, 0, 1});
    EXPECT_EQ(inner.Counts(), (TierCounts{1, 2, 0, 1}));
  }
  EXPECT_EQ(outer.Counts(), (TierCounts{2, 2, 0, 1}));
}

TEST(EdgeSign, FilterIsSilentWithinItsOwnErrorBound) {
  // Of these |E| is one part in 2^48 to 2^106, and most anchors make the differences round.
  Draw draw(11);
  const TierScope scope;
  for (int k = 0; k < 1000; ++k) {
    const auto [a, b, p] = draw.EdgeAndPoint(Family::kMovedHardest);
    ASSERT_EQ(EdgeSign(a, b, p), NaiveEdgeSign(a, b, p));
  }
  EXPECT_GT(scope.Counts().exact, 500U);
}

TEST(ShiftedEdgeSign, IsTheSignAtTheMovedSampleUnderEveryRule) {
  Draw draw(13);
  int ties = 0;
  for (int k = 0; k < 4000; ++k) {
    const Family family = k % 2 == 0 ? Family::kHalfPixels : static_cast<Family>(k % kFamilies);
    const auto [a, b, p] = draw.EdgeAndPoint(family);
    const TieRule rule = draw.AnyProfile().tie_rule;
    const int truth = sgn(NaiveEdge(NaiveAt(a), NaiveAt(b), NaiveShifted(NaiveAt(p), rule)));
    for (const Decider decider : kDeciders) {
      ASSERT_EQ(ShiftedEdgeSign(a, b, p, rule, decider), truth) << TieRuleName(rule);
    }
    if (EdgeSign(a, b, p) == 0 && truth != 0) ++ties;
  }
  EXPECT_GT(ties, 200) << "the shift was hardly ever asked";
}

TEST(EdgeValue, IsTheExactNumber) {
  EXPECT_EQ(EdgeValue({0, 0}, {3, 5}, {2, 1}).ToString(), "7");
  EXPECT_EQ(EdgeValue({0.5, 0}, {1, 0.25}, {2, 1}).ToString(), "-1/8");
  EXPECT_EQ(EdgeValue({0, 0}, {kLeast, 0}, {0, kLeast}).ToDouble(), 0);
  EXPECT_EQ(EdgeValue({0, 0}, {kLeast, 0}, {0, kLeast}).Sign(), -1);
}

}  // namespace
}  // namespace rasterproof::exact
