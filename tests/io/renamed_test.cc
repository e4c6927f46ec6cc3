// The text of a message about a word that was replaced.
#include "io/renamed.h"

#include <gtest/gtest.h>

namespace rasterproof::io {
namespace {

TEST(Renamed, TextNamesTheNewWordOfAnOldOneAndNothingForOthers) {
  EXPECT_EQ(RenamedText("fill_rule"), ", which is tie_rule now");
  EXPECT_EQ(RenamedText("WinnerFollowsTheDeclaredOrder"),
            ", which is PrimitiveIdFollowsTheStatedOrder now");
  EXPECT_EQ(RenamedText("conservative-under"), ", which is at-most-model now");
  EXPECT_EQ(RenamedText("tie_rule"), "");
  EXPECT_EQ(RenamedText(""), "");
}

}  // namespace
}  // namespace rasterproof::io
