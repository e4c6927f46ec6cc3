#include "core/sample_rows.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/hash_text.h"

namespace rasterproof {
namespace {

TEST(SampleRows, HaveTheFirstSampleInTheLastBit) {
  const std::vector<std::size_t> samples{10, 11, 14, 27};
  const SampleRows rows = RowsOf(samples, 10);
  EXPECT_EQ(rows.top, 1U);
  EXPECT_EQ(rows.rows, (std::vector<std::string>{"013", "080"}));
  EXPECT_EQ(RowOf(samples, 0, 10), "000");
}

TEST(SampleRows, ComeBackAsTheyWere) {
  const std::vector<std::size_t> samples{0, 64, 127, 129, 300};
  for (const std::size_t row_length : {1U, 3U, 4U, 64U, 65U}) {
    const SampleRows rows = RowsOf(samples, row_length);
    std::vector<std::size_t> read;
    for (std::size_t k = 0; k < rows.rows.size(); ++k)
      EXPECT_EQ(AddRow(rows.rows[k], rows.top + k, row_length, read), "");
    EXPECT_EQ(read, samples) << row_length;
  }
}

TEST(SampleRows, OfAnEmptySetAreNone) { EXPECT_TRUE(RowsOf({}, 8).rows.empty()); }

TEST(SampleRows, AreReadInCapitalsAndWithoutLeadingZeros) {
  std::vector<std::size_t> read;
  EXPECT_EQ(AddRow("A", 1, 9, read), "");
  EXPECT_EQ(read, (std::vector<std::size_t>{10, 12}));
  EXPECT_EQ(AddRow("0000100", 0, 9, read), "");
  EXPECT_EQ(read.back(), 8U);
}

TEST(SampleRows, BeyondTheTargetOrWithOtherLettersAreNone) {
  std::vector<std::size_t> read;
  EXPECT_NE(AddRow("200", 0, 9, read), "");
  EXPECT_NE(AddRow("0x1", 0, 9, read), "");
  EXPECT_NE(AddRow("", 0, 9, read), "");
}

// The published values: http://www.isthe.com/chongo/src/fnv/test_fnv.c
TEST(HashText, IsFnv1a) {
  EXPECT_EQ(HashText(""), "cbf29ce484222325");
  EXPECT_EQ(HashText("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(HashText("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace rasterproof
