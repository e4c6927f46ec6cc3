// What a message says of a word that was replaced.
#include "core/renamed.h"

#include <gtest/gtest.h>

namespace rasterproof {
namespace {

TEST(Renamed, OldWordsAreToldTheirNewOnesAndOthersNothing) {
  EXPECT_EQ(RenamedText("fill_rule"), ", which is tie_rule now");
  EXPECT_EQ(RenamedText("WinnerFollowsTheDeclaredOrder"),
            ", which is PrimitiveIdFollowsTheStatedOrder now");
  EXPECT_EQ(RenamedText("conservative-under"), ", which is at-most-model now");
  EXPECT_EQ(RenamedText("tie_rule"), "");
  EXPECT_EQ(RenamedText(""), "");
}

}  // namespace
}  // namespace rasterproof
