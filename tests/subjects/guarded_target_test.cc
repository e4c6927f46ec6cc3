#include "subjects/plugin/guarded_target.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace rasterproof::subjects {
namespace {

TEST(GuardedCounts, StartAtZeroAndShowNoDamageOfTheirOwn) {
  GuardedCounts counts(5, 3);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(counts.data()[row * counts.stride() + k], 0U);
      counts.data()[row * counts.stride() + k] = static_cast<std::uint32_t>(row + k);
    }
  }
  EXPECT_EQ(counts.Damage(), "");
  EXPECT_EQ(counts.Row(2)[4], 6U);
}

TEST(GuardedCounts, NameTheFirstPlaceThatWasWritten) {
  const auto damage = [](std::ptrdiff_t row, std::ptrdiff_t column) {
    GuardedCounts counts(5, 3);
    counts.data()[row * static_cast<std::ptrdiff_t>(counts.stride()) + column] += 1;
    return counts.Damage();
  };
  EXPECT_EQ(damage(1, 5), "column 5 of row 1 of a target of 3 rows of 5 counts");
  EXPECT_EQ(damage(-1, 2).substr(0, 18), "column 2 of row -1");
  EXPECT_EQ(damage(3, 0).substr(0, 17), "column 0 of row 3");
  EXPECT_EQ(damage(2, 4), "");
}

TEST(GuardedCountsDeathTest, EndAtAClosedPage) {
  EXPECT_DEATH(
      {
        GuardedCounts counts(1000, 1);
        counts.data()[std::ptrdiff_t{5} * static_cast<std::ptrdiff_t>(counts.stride())] = 1;
      },
      "");
}

}  // namespace
}  // namespace rasterproof::subjects
