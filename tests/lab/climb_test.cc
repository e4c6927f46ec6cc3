// The search for the largest error over its bound.
#include "lab/climb/climb.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

#include "core/profile.h"
#include "core/subject_info.h"
#include "props/run/campaign.h"
#include "subjects/builtin/builtin.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::lab {
namespace {

Climbed ClimbOn(std::string_view subject, std::string_view property, std::uint64_t seed = 1) {
  const auto made = subjects::MakeBuiltin(subject);
  return ClimbRatio(*made, *props::FindProperty(property), {.seed = seed, .evaluations = 4000});
}

TEST(Climb, GoesBeyondTheCasesThatItSetOutFromAndStaysWithinTheBound) {
  const Climbed found = ClimbOn("f32-direct", "EdgeErrorStaysWithinItsBound");
  ASSERT_TRUE(found.best.has_value());
  EXPECT_EQ(found.verdict.outcome, Outcome::kHolds);
  EXPECT_EQ(found.evaluations, 4000U);
  EXPECT_GT(found.drawn_ratio, 0);
  EXPECT_GT(found.verdict.worst_ratio, found.drawn_ratio);
  EXPECT_LE(found.verdict.worst_ratio, 1);
}

TEST(Climb, FindsTheSameAgainAndSomethingElseFromAnotherSeed) {
  const Climbed one = ClimbOn("f32-kahan", "EdgeErrorStaysWithinItsBound", 1);
  const Climbed again = ClimbOn("f32-kahan", "EdgeErrorStaysWithinItsBound", 1);
  const Climbed other = ClimbOn("f32-kahan", "EdgeErrorStaysWithinItsBound", 2);
  ASSERT_TRUE(one.best && again.best && other.best);
  EXPECT_EQ(*one.best, *again.best);
  EXPECT_NE(*one.best, *other.best);
}

TEST(Climb, NeverEndsBelowTheCaseThatItIsGiven) {
  const Climbed far = ClimbOn("f32-direct", "EdgeErrorStaysWithinItsBound");
  ASSERT_TRUE(far.best.has_value());
  const auto subject = subjects::MakeBuiltin("f32-direct");
  const Climbed found = ClimbRatio(*subject, *props::FindProperty("EdgeErrorStaysWithinItsBound"),
                                   {.seed = 2, .evaluations = 200, .from = far.best});
  EXPECT_LT(found.drawn_ratio, far.verdict.worst_ratio);
  EXPECT_GE(found.verdict.worst_ratio, far.verdict.worst_ratio);
}

TEST(Climb, KeepsToWhatTheSubjectTakes) {
  const auto subject = subjects::MakeBuiltin("f32-direct");
  const Climbed found = ClimbOn("f32-direct", "EdgeErrorStaysWithinItsBound");
  ASSERT_TRUE(found.best.has_value());
  EXPECT_TRUE(Takes(subject->Info(), found.best->scene));
  EXPECT_TRUE(WithinLimits(found.best->scene, found.best->profile));
}

TEST(Climb, FindsNothingWhereNothingIsCompared) {
  const Climbed found = ClimbOn("spans-exact", "CoverageEqualsTheModel");
  EXPECT_FALSE(found.best.has_value());
}

TEST(Climb, EndsWithAViolation) {
  auto wrong = props::testing::DropsLastColumn(props::testing::RealInfo());
  const Climbed found =
      ClimbRatio(wrong, *props::FindProperty("CoverageEqualsTheModel"), {.evaluations = 500});
  ASSERT_TRUE(found.best.has_value());
  EXPECT_EQ(found.verdict.outcome, Outcome::kViolated);
  EXPECT_LT(found.evaluations, 500U);
  EXPECT_EQ(RunCase(wrong, *props::FindProperty("CoverageEqualsTheModel"), *found.best).outcome,
            Outcome::kViolated);
}

}  // namespace
}  // namespace rasterproof::lab
