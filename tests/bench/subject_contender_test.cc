#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "bench/contender.h"
#include "bench/errors.h"
#include "bench/limits.h"
#include "bench/scene_drawer.h"
#include "core/call_end.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/subject.h"

namespace rasterproof::bench {
namespace {

// Takes the time that the test sets, and draws nothing, or all of the target.
class Scripted final : public Subject {
 public:
  const SubjectInfo& OwnInfo() const override { return info; }
  void Draw(const Scene& /*scene*/, const DrawOptions& /*options*/,
            CoverageCounts& counts) override {
    if (breaks_down) BreakDown("it was killed by signal 11");
    ++drawn;
    if (fills) counts.front.assign(counts.front.size(), 1);
  }
  std::optional<DrawTime> TimeDraws(const DrawJob& job, int repeats) override {
    const double one = job.Triangles().empty() ? empty_seconds : seconds;
    return DrawTime{.seconds = start_seconds + one * repeats,
                    .wall_seconds = start_seconds + wall_factor * one * repeats};
  }

  SubjectInfo info;
  double start_seconds = 0;
  double seconds = 0;
  double empty_seconds = 0;
  double wall_factor = 1;
  bool breaks_down = false;
  bool fills = false;
  int drawn = 0;
};

FamilyInput OneTriangle() {
  Scene scene;
  scene.name = "one";
  scene.width = scene.height = 8;
  scene.vertices = {{1, 1}, {7, 1}, {1, 7}};
  scene.triangles = {{0, 2, 1}};
  return FamilyOf(std::move(scene), "A triangle");
}

TEST(ProgramContender, TakesTheSlopeOverRepeats) {
  Scripted burns;
  burns.info.takes_repeats = true;
  burns.start_seconds = 0.5;
  burns.seconds = 1;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeProgramContender(burns);
  contender->Load(family);
  EXPECT_NEAR(contender->Draw().seconds, 1, 1e-12);
  EXPECT_NEAR(contender->conversion_seconds(), 0.5, 1e-12);
  EXPECT_FALSE(contender->method().times_requests);
  EXPECT_EQ(contender->method().clock, BenchClock::kProgram);
  burns.seconds = 0;
  EXPECT_EQ(contender->Draw().seconds, 0) << "one that draws nothing takes nothing";
}

TEST(ProgramContender, TellsWhatARequestWithoutTrianglesTakesIfThereAreNoRepeats) {
  Scripted reads;
  reads.start_seconds = 0.25;
  reads.seconds = 2;
  reads.empty_seconds = 0.75;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeProgramContender(reads);
  contender->Load(family);
  EXPECT_NEAR(contender->Draw().seconds, 2, 1e-12);
  EXPECT_NEAR(contender->conversion_seconds(), 0.75, 1e-12);
  EXPECT_TRUE(contender->method().times_requests);
}

TEST(ProgramContender, IsLeftOutWhereItsDrawsTakeMoreThanTheBudgetHas) {
  Scripted slow;
  slow.start_seconds = 0.25;
  slow.seconds = 0.75;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeProgramContender(slow);
  contender->LimitTime(15);
  contender->Load(family);
  contender->LimitTime(14.9);
  try {
    contender->Load(family);
    FAIL();
  } catch (const SubjectStop& stop) {
    EXPECT_EQ(stop.stop(), Stop::kTooSlow);
    EXPECT_EQ(
        std::string(stop.what()),
        "a draw takes 1 s, and 15 of them more than the 15 s that the budget has for it here; "
        "give a --budget 1.1 times as large, or fewer families");
  }
}

TEST(ProgramContender, CountsElapsedTimeOfWhatDrawsElsewhere) {
  Scripted waits;
  waits.info.takes_repeats = true;
  waits.info.draws_elsewhere = true;
  waits.seconds = 0.125;
  waits.wall_factor = 4;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeProgramContender(waits);
  contender->Load(family);
  EXPECT_NEAR(contender->Draw().seconds, 0.5, 1e-12);
  EXPECT_EQ(contender->method().clock, BenchClock::kWall);
}

TEST(LibraryContender, LeavesOutWhatADrawWithoutTrianglesTakes) {
  Scripted converts;
  converts.seconds = 5;
  converts.empty_seconds = 2;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeSubjectContender(converts);
  contender->Load(family);
  EXPECT_DOUBLE_EQ(contender->Draw().seconds, 3);
  EXPECT_DOUBLE_EQ(contender->conversion_seconds(), 2);
}

TEST(SubjectContender, StandsBesideKernelsOfItsSink) {
  Scripted subject;
  EXPECT_EQ(MakeSubjectContender(subject)->method().sink, "facing");
  subject.info.coverage = CoverageKind::kMask;
  EXPECT_EQ(MakeSubjectContender(subject)->method().sink, "mask");
}

TEST(SubjectContender, IsJudgedPairByPair) {
  Scripted nothing;
  const FamilyInput family = OneTriangle();
  const auto contender = MakeSubjectContender(nothing);
  contender->Load(family);
  const JudgedTriangles judged(family.scene, 1000);
  CoverageJudge judge(family, judged);
  const Judgement missing = judge.Of(*contender);
  EXPECT_EQ(missing.judged_triangles, 1U);
  EXPECT_EQ(missing.real.missing, 15U);  // 5 + 4 + 3 + 2 + 1: its long side is not owned
  EXPECT_EQ(missing.real.lost, 0U);      // below 16 pairs
  EXPECT_LE(missing.real.beside_edges, missing.boundary_pairs);
  nothing.fills = true;
  CoverageJudge again(family, judged);
  EXPECT_EQ(again.Of(*contender).real.unexpected, 64U - 15U);
}

TEST(RunFamily, LeavesOutAUsersSubjectThatBreaksDown) {
  Scripted breaks;
  breaks.breaks_down = true;
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(MakeSubjectContender(breaks));
  BenchOptions options;
  options.seconds_per_family = 0;
  options.least_rounds = 1;
  BenchResult result;
  RunFamily(OneTriangle(), contenders, options, result);
  EXPECT_TRUE(result.rows.empty());
  ASSERT_EQ(result.left_out.size(), 1U);
  EXPECT_EQ(result.left_out.front().why, "it was killed by signal 11");
}

// In a whole run limits come first: they are the contender's, under its own name.
TEST(RunLimits, AddsNoSecondMethodForAUsersSubject) {
  Scripted nothing;
  const auto contender = MakeSubjectContender(nothing);
  BenchResult result;
  result.methods.push_back(contender->method());
  LimitOptions options;
  options.parameters = {"grid-8"};
  RunLimits(*DrawerOf(nothing, contender->method()), options, result);
  EXPECT_EQ(result.methods.size(), 1U);
  ASSERT_EQ(result.cliffs.size(), 1U);
  EXPECT_EQ(result.cliffs.front().method, 0U);
}

}  // namespace
}  // namespace rasterproof::bench
