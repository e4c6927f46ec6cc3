#include "tool/exit_status.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace rasterproof::tool {
namespace {

TEST(ExitStatus, OfOneVerdictIsGreenOnlyIfItHolds) {
  EXPECT_EQ(StatusOf(Outcome::kHolds), kExitHolds);
  EXPECT_EQ(StatusOf(Outcome::kViolated), kExitViolated);
  for (const Outcome outcome : {Outcome::kNotExercised, Outcome::kNotApplicable, Outcome::kRefused,
                                Outcome::kInconclusive}) {
    EXPECT_EQ(StatusOf(outcome), kExitInconclusive) << OutcomeName(outcome);
  }
}

TEST(ExitStatus, OfSeveralSubjectsIsTheWorst) {
  constexpr std::array<int, 5> kWorstFirst{kExitFault, kExitUsage, kExitViolated, kExitInconclusive,
                                           kExitHolds};
  for (std::size_t worse = 0; worse < kWorstFirst.size(); ++worse) {
    for (std::size_t better = worse; better < kWorstFirst.size(); ++better) {
      EXPECT_EQ(WorseStatus(kWorstFirst[worse], kWorstFirst[better]), kWorstFirst[worse]);
      EXPECT_EQ(WorseStatus(kWorstFirst[better], kWorstFirst[worse]), kWorstFirst[worse]);
    }
  }
}

}  // namespace
}  // namespace rasterproof::tool
