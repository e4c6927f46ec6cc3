#include "core/coverage.h"

#include "core/error.h"
#include "gtest/gtest.h"

namespace rasterproof {
namespace {

TEST(CoverageTest, GapsAndOverlapsAreReportedApart) {
  CoverageCounts expected(3, 1);
  expected.front = {1, 1, 0};
  CoverageCounts observed(3, 1);
  observed.front = {1, 0, 0};
  observed.back = {0, 0, 2};
  const CoverageDifference difference = Compare(observed, expected);
  EXPECT_EQ(difference.samples, 3U);
  EXPECT_EQ(difference.covered, 2U);
  EXPECT_EQ(difference.wrong, 2U);
  EXPECT_EQ(difference.missing, 1U);
  EXPECT_EQ(difference.unexpected, 1U);
  EXPECT_EQ(difference.first_wrong, 1U);
}

TEST(CoverageTest, AWrongFacingIsWrongButNeitherGapNorOverlap) {
  CoverageCounts expected(1, 1);
  expected.front = {1};
  CoverageCounts observed(1, 1);
  observed.back = {1};
  const CoverageDifference difference = Compare(observed, expected);
  EXPECT_EQ(difference.wrong, 1U);
  EXPECT_EQ(difference.missing + difference.unexpected, 0U);
}

TEST(CoverageTest, CountsOfOtherSamplesAreNeitherReadNorAdded) {
  CoverageCounts one(2, 2, 1);
  CoverageCounts four(2, 2, 4);
  EXPECT_THROW(Compare(one, four), InputError);
  EXPECT_THROW(Compare(four, one), InputError);
  EXPECT_THROW(four += one, InputError);
  EXPECT_THROW(one += four, InputError);
  EXPECT_EQ(one, CoverageCounts(2, 2, 1));
}

}  // namespace
}  // namespace rasterproof
