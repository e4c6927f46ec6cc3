#include "core/edge_claims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/evaluators.h"

namespace rasterproof {
namespace {

// What is stated alone: no values are asked for.
class Stated final : public ClaimedEdges {
 public:
  using ClaimedEdges::ClaimedEdges;
  double Value(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override { return 0; }
  std::vector<double> Walk(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/, Step /*step*/,
                           int steps) const override {
    return std::vector<double>(static_cast<std::size_t>(steps) + 1);
  }
};

EdgeClaims OfThreeRoundings() {
  EdgeClaims claims;
  claims.value_error = 3;
  claims.walk_error = 3;
  return claims;
}

TEST(ClaimedEdges, SayNothingWhereADifferenceOverflowsThoughItIsMultipliedByZero) {
  const Stated edges(OfThreeRoundings(), Precision::kFloat32);
  const Point2 a{0, 0x1p127};
  const Point2 b{0, -0x1p127};
  EXPECT_TRUE(std::isnan(edges.ErrorBound(a, b, a)));
  EXPECT_TRUE(std::isnan(edges.WalkErrorBounds(a, b, a, {}, 1)[0]));
  // In float64 the same is far from the end of the range.
  const Stated doubles(OfThreeRoundings(), Precision::kFloat64);
  EXPECT_FALSE(std::isnan(doubles.ErrorBound(a, b, a)));
}

TEST(ClaimedEdges, SayNothingWhereAProductMayOverflow) {
  const Stated edges(OfThreeRoundings(), Precision::kFloat32);
  EXPECT_TRUE(std::isnan(edges.ErrorBound({0, 0}, {0x1p63, 0x1p63}, {0x1p63, 0})));
  EXPECT_GT(edges.ErrorBound({0, 0}, {0x1p62, 0x1p62}, {0x1p62, 0}), 0);
}

}  // namespace
}  // namespace rasterproof
