// Names of what a transform is made of.
#include <gtest/gtest.h>

#include "core/transform.h"

namespace rasterproof {
namespace {

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
