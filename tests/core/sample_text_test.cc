#include "core/sample_text.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace rasterproof {
namespace {

TEST(SampleText, NamesTheSampleWhereAPixelHasSeveral) {
  EXPECT_EQ(PixelText(11, 4), "column 3 row 2");
  EXPECT_EQ(SampleText(11, 4, 1), "column 3 row 2");
  EXPECT_EQ(SampleText(45, 4, 4), "column 3 row 2 sample 1");
}

TEST(RangeText, IsOneNumberWhereThereIsOne) {
  EXPECT_EQ(RangeText(2, 2), "2");
  EXPECT_EQ(RangeText(std::uint32_t{1}, std::uint32_t{3}), "1 to 3");
}

}  // namespace
}  // namespace rasterproof
