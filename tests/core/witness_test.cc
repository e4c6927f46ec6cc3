#include "core/witness.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace rasterproof {
namespace {

TEST(Witness, ItsValuesAreToldInTheOrderOfASentence) {
  EXPECT_EQ(TextOfValue({}), "");
  EXPECT_EQ(TextOfValue({"covered ", 2, " times"}), "covered 2 times");
  EXPECT_EQ(TextOfValue({FacingCounts{1, 0}}), "front 1, back 0");
  EXPECT_EQ(TextOfValue({CountSet{0b101}, " in every legal model"}), "0 or 2 in every legal model");
  EXPECT_EQ(TextOfValue({CountSet{std::uint64_t{1} << 63}}), "63");
  EXPECT_EQ(TextOfValue({"E = ", RationalText{"-3/4"}, " within ", 0.5}), "E = -3/4 within 0x1p-1");
}

TEST(Witness, WordsThatLookLikeCountsAreWords) {
  const WitnessValue words{"front 1, back 0"};
  const WitnessValue counts{FacingCounts{1, 0}};
  EXPECT_EQ(TextOfValue(words), TextOfValue(counts));
  EXPECT_NE(words, counts);
}

}  // namespace
}  // namespace rasterproof
