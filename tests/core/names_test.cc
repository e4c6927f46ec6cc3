// Names of what a profile says of placing.
#include <gtest/gtest.h>

#include <optional>

#include "core/snap.h"
#include "core/transform.h"

namespace rasterproof {
namespace {

TEST(Names, OfSnapFormsAreReadBack) {
  for (const SnapForm form :
       {SnapForm::kCoordinate, SnapForm::kFloat32Difference, SnapForm::kExactDifference}) {
    EXPECT_EQ(SnapFormFromName(SnapFormName(form)), form);
  }
  EXPECT_EQ(SnapFormFromName("edge"), std::nullopt);
}

TEST(Names, OfSnapRulesAreReadBack) {
  for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kNearestAway, SnapRule::kHalfUp,
                              SnapRule::kFloor, SnapRule::kTruncate}) {
    EXPECT_EQ(SnapRuleFromName(SnapRuleName(rule)), rule);
  }
}

TEST(Names, OfTransformsAreReadBack) {
  for (const Division division : {Division::kQuotient, Division::kReciprocal}) {
    EXPECT_EQ(DivisionFromName(DivisionName(division)), division);
  }
  for (const ViewportForm form : {ViewportForm::kNone, ViewportForm::kMultiplyAdd,
                                  ViewportForm::kFused, ViewportForm::kAddMultiply}) {
    EXPECT_EQ(ViewportFormFromName(ViewportFormName(form)), form);
  }
  EXPECT_FALSE(DivisionFromName("quotients"));
  EXPECT_FALSE(ViewportFormFromName(""));
}

}  // namespace
}  // namespace rasterproof
