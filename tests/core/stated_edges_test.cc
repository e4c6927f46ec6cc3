#include "core/stated_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/evaluators.h"

namespace rasterproof {
namespace {

// What is stated alone: no values are asked for.
class Stated final : public StatedEdges {
 public:
  using StatedEdges::StatedEdges;
  double Value(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override { return 0; }
  std::vector<double> Steps(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/, Step /*step*/,
                            int steps) const override {
    return std::vector<double>(static_cast<std::size_t>(steps) + 1);
  }
};

EdgeInfo OfThreeRoundings() {
  EdgeInfo properties;
  properties.value_error = 3;
  properties.stepping_error = 3;
  return properties;
}

TEST(StatedEdges, SayNothingWhereADifferenceOverflowsThoughItIsMultipliedByZero) {
  const Stated edges(OfThreeRoundings(), Precision::kFloat32);
  const Point2 a{0, 0x1p127};
  const Point2 b{0, -0x1p127};
  EXPECT_TRUE(std::isnan(edges.ErrorBound(a, b, a)));
  EXPECT_TRUE(std::isnan(edges.SteppingErrorBounds(a, b, a, {}, 1)[0]));
  // In float64 the same is far from the end of the range.
  const Stated doubles(OfThreeRoundings(), Precision::kFloat64);
  EXPECT_FALSE(std::isnan(doubles.ErrorBound(a, b, a)));
}

TEST(StatedEdges, SayNothingWhereAProductMayOverflow) {
  const Stated edges(OfThreeRoundings(), Precision::kFloat32);
  EXPECT_TRUE(std::isnan(edges.ErrorBound({0, 0}, {0x1p63, 0x1p63}, {0x1p63, 0})));
  EXPECT_GT(edges.ErrorBound({0, 0}, {0x1p62, 0x1p62}, {0x1p62, 0}), 0);
}

}  // namespace
}  // namespace rasterproof
