// What a channel may hold at a centroid: at the stated point, or at any of pixel and triangle.
#include "props/judging/values/centroid_values.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/drawing.h"
#include "core/value_rule.h"
#include "exact/half_planes.h"
#include "exact/values.h"

namespace rasterproof::props {
namespace {

// The triangle (0, 0), (8, 0), (0, 8), at the pixel of column 4 and row 3: of it x + y <= 8.
class CentroidValues : public testing::Test {
 protected:
  CentroidValues() {
    fragment_.vertices = {0, 1, 2};
    fragment_.place.at = {4.25, 3.25};
    fragment_.centroid =
        CentroidRegion{.at = {},
                       .low = {4, 3},
                       .high = {5, 4},
                       .primitive = std::make_shared<const std::vector<exact::HalfPlane>>(
                           exact::HullOf({{0, 0}, {8, 0}, {0, 8}})),
                       .words = "here"};
    owners_.corners = {{{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}}};
    owners_.known = exact::WindowTriangle({{{0, 0}, {8, 0}, {0, 8}}});
    rule_.error.absolute = 0x1p-20;
  }

  ValueCheck Check(double x) const {
    const ShownValues shown{drawing_, channels_, rule_, Precision::kFloat32};
    return CheckCentroidValue(shown, fragment_, owners_, channels_[0], x);
  }
  bool Holds(double x) const {
    const ValueCheck check = Check(x);
    EXPECT_TRUE(check.is_judged);
    EXPECT_TRUE(check.tells);
    return check.holds;
  }

  Drawing drawing_;
  // x + y.
  std::vector<Channel> channels_{
      {"sum", Interpolation::kPerspective, EvaluatedAt::kCentroid, {0, 8, 8}}};
  ValueRule rule_;
  ValueFragment fragment_;
  ValueOwners owners_;
};

TEST_F(CentroidValues, AreOfAPointOfPixelAndTriangle) {
  for (const double x : {7.0, 7.5, 8.0, 8 + 0x1p-20, 7 - 0x1p-20}) EXPECT_TRUE(Holds(x)) << x;
  // Beyond the tolerance; in the pixel alone; nowhere near.
  for (const double x : {8 + 0x1p-19, 7 - 0x1p-19, 8.5, 9.0, 0.0, -1.0})
    EXPECT_FALSE(Holds(x)) << x;
}

TEST_F(CentroidValues, AreOfThePixelWhereThePrimitiveIsNotKnown) {
  fragment_.centroid->primitive = nullptr;
  for (const double x : {7.0, 8.5, 9.0}) EXPECT_TRUE(Holds(x)) << x;
  EXPECT_FALSE(Holds(9.5));
  owners_.known.reset();
  EXPECT_TRUE(Holds(9.0));
  EXPECT_FALSE(Holds(9.5));
}

TEST_F(CentroidValues, AreOfTheStatedPoint) {
  fragment_.centroid->at = {4.5, 3.25};
  EXPECT_TRUE(Check(7.75).holds);
  EXPECT_FALSE(Check(7.5).holds) << "elsewhere in pixel and triangle";
}

// u = x and v = y, whose points are those of x + y <= 8 in columns 4 to 5 and rows 3 to 4.
TEST_F(CentroidValues, OfAllChannelsAreOfOnePoint) {
  channels_ = {{"u", Interpolation::kPerspective, EvaluatedAt::kCentroid, {0, 8, 0}},
               {"v", Interpolation::kLinear, EvaluatedAt::kCentroid, {0, 0, 8}},
               {"w", Interpolation::kPerspective, EvaluatedAt::kSample, {0, 0, 1}}};
  const auto have_one = [&](double u, double v) {
    drawing_.values = {u, v, 100};
    const ShownValues shown{drawing_, channels_, rule_, Precision::kFloat32};
    return AreOfOnePoint(shown, fragment_, owners_);
  };
  EXPECT_TRUE(have_one(4.25, 3.25));
  EXPECT_TRUE(have_one(4.75, 3.25)) << "on the edge";
  EXPECT_TRUE(have_one(4.75, 3.25 + 0x1p-20)) << "each within its error";
  // Each is that of a legal point: of (4.75, 3) and of (4, 3.75).
  EXPECT_FALSE(have_one(4.75, 3.75));
  EXPECT_FALSE(have_one(4.75, 3.25 + 0x1p-18));
  owners_.known.reset();
  EXPECT_TRUE(have_one(4.75, 3.75)) << "nothing is known of the corners";
}

TEST_F(CentroidValues, AreNotJudgedAroundTheEye) {
  owners_.corners[0][2] = {0, -8, -1};
  owners_.known = {{{0, 0, 1}, {8, 0, 1}, {0, -8, -1}}};
  EXPECT_FALSE(Check(100).is_judged);
}

}  // namespace
}  // namespace rasterproof::props
