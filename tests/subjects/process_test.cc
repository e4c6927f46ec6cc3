// What a program on a pipe may cost, and who is to blame where it costs more.
#include "subjects/process/process.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/scene.h"

namespace rasterproof::subjects {
namespace {

// As the command does: a program may end before it has read all that it is asked.
const bool kIgnoresClosedPipes = std::signal(SIGPIPE, SIG_IGN) != SIG_ERR;

// Draws nothing onto targets of one sample, `pause` before every answer. A line in $STARTS for
// every process.
std::vector<std::string> Pausing(const std::string& pause) {
  return {"/bin/sh", "-c",
          "test -z \"$STARTS\" || echo started >> \"$STARTS\"\n"
          "while read word id width rest; do\n"
          "  case $word in\n"
          "    batch)\n"
          "      all= n=$id\n"
          "      while [ $n -gt 0 ]; do\n"
          "        read word id width rest; " +
              pause +
              "\n"
              "        all=\"${all}counts $id\\n0\\n\" n=$((n - 1))\n"
              "      done\n"
              "      printf \"$all\" ;;\n"
              "    *) " +
              pause +
              "; printf \"counts $id\\n0\\n\" ;;\n"
              "  esac\n"
              "done\n"};
}

SubjectInfo Info() {
  SubjectInfo info;
  info.name = "pausing";
  info.coverage = CoverageKind::kCounts;
  return info;
}

// "" if it drew, else "fault: ..." or "slow: ...".
std::string SaidOf(Subject& subject, const DrawJob& job = {}) {
  const CallEnd end = subject.DrawMany({&job, 1}).front().end;
  if (end.stop == Stop::kNone) return "";
  return (IsBreakdown(end.stop) ? "fault: " : "slow: ") + end.why;
}

bool Has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(ProcessSubject, CallsAHangOneAfterTenTimesTheLimitAndSparesTheNextOneThat) {
  ProcessSubject subject(Pausing("sleep 1000"), Info(), {.seconds = 0.05});
  const std::string first = SaidOf(subject);
  EXPECT_TRUE(first.starts_with("fault: it hangs: alone, on a fresh process")) << first;
  EXPECT_TRUE(Has(first, "slept for")) << first;
  const std::string second = SaidOf(subject);
  EXPECT_TRUE(second.starts_with("fault: it hangs")) << second;
  EXPECT_TRUE(Has(second, "as before")) << second;
}

TEST(ProcessSubject, CallsASlowOneSlowAndTriesItABoundedNumberOfTimes) {
  const std::string starts = testing::TempDir() + "/starts";
  std::ofstream(starts).close();
  setenv("STARTS", starts.c_str(), 1);
  ProcessSubject subject(Pausing("sleep 0.3"), Info(), {.seconds = 0.1});
  for (int n = 0; n < 3; ++n) {
    const std::string said = SaidOf(subject);
    EXPECT_TRUE(said.starts_with("slow: alone, on a fresh process, it answered after")) << said;
    EXPECT_TRUE(Has(said, "--time-limit")) << said;
  }
  const std::string last = SaidOf(subject);
  unsetenv("STARTS");
  EXPECT_TRUE(Has(last, "gave no answer; raise --time-limit (now 0.1 s)")) << last;
  std::ifstream in(starts);
  int started = 0;
  for (std::string line; std::getline(in, line);) ++started;
  EXPECT_EQ(started, 4) << "one, and a fresh one for each try";
}

// Before the fifth answer of each process it does `what`.
std::vector<std::string> OnTheFifth(const std::string& what) {
  return Pausing("c=$((c + 1)); [ $c -ne 5 ] || " + what);
}

TEST(ProcessSubject, TellsAHangThatAFreshProcessDoesNotDoAgain) {
  ProcessSubject subject(OnTheFifth("sleep 1000"), Info(), {.seconds = 0.05});
  for (int n = 0; n < 4; ++n) EXPECT_EQ(SaidOf(subject), "");
  const std::string said = SaidOf(subject);
  EXPECT_TRUE(said.starts_with("fault: it hangs: it slept for")) << said;
  EXPECT_TRUE(Has(said, "10 times its limit of 0.05 s")) << said;
  EXPECT_TRUE(Has(said, "on a fresh process, it answered: it did not happen again")) << said;
  EXPECT_EQ(SaidOf(subject), "");
}

TEST(ProcessSubject, TellsAHangAmongManyDrawsThatDoesNotHappenAgain) {
  ProcessSubject subject(OnTheFifth("sleep 1000"), Info(), {.seconds = 0.05});
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(std::vector<DrawJob>(8));
  ASSERT_EQ(outcomes.size(), 5U) << "what follows is left open";
  EXPECT_EQ(outcomes[3].end.stop, Stop::kNone);
  EXPECT_EQ(outcomes[4].end.stop, Stop::kHung);
  EXPECT_TRUE(Has(outcomes[4].end.why, "it did not happen again")) << outcomes[4].end.why;
}

TEST(ProcessSubject, TellsOfABatchWhatItsPartsDoNotDoAgain) {
  SubjectInfo info = Info();
  info.takes_batches = true;
  const std::vector<DrawJob> jobs(8);
  const std::string marker = testing::TempDir() + "/once";
  // In a file, as a process's fifth call would come again in the parts.
  const auto once = [&](const std::string& what) {
    std::remove(marker.c_str());
    return OnTheFifth("test -e " + marker + " || { : > " + marker + "; " + what + "; }");
  };
  ProcessSubject hangs(once("sleep 1000"), info, {.seconds = 0.2});
  const std::vector<DrawOutcome> hung = hangs.DrawMany(jobs);
  ASSERT_EQ(hung.size(), 1U);
  EXPECT_EQ(hung[0].end.stop, Stop::kHung);
  EXPECT_TRUE(Has(hung[0].end.why, "asked 8 requests at once, it slept for")) << hung[0].end.why;
  EXPECT_TRUE(Has(hung[0].end.why, "it did not happen again")) << hung[0].end.why;
  ProcessSubject crashes(once("kill -SEGV $$"), info);
  const std::vector<DrawOutcome> crashed = crashes.DrawMany(jobs);
  ASSERT_EQ(crashed.size(), 1U);
  EXPECT_EQ(crashed[0].end.stop, Stop::kBrokeDown);
  EXPECT_TRUE(Has(crashed[0].end.why, "killed by signal 11")) << crashed[0].end.why;
  EXPECT_TRUE(Has(crashed[0].end.why, "do not do it again")) << crashed[0].end.why;
}

TEST(ProcessSubject, TakesTheAnswerOfWhatIsSlowOnceInAWhile) {
  for (const bool takes_batches : {false, true}) {
    SubjectInfo info = Info();
    info.takes_batches = takes_batches;
    ProcessSubject subject(OnTheFifth("sleep 0.5"), info, {.seconds = 0.2});
    const std::vector<DrawOutcome> outcomes = subject.DrawMany(std::vector<DrawJob>(8));
    ASSERT_EQ(outcomes.size(), 8U);
    for (const DrawOutcome& outcome : outcomes) {
      EXPECT_EQ(outcome.end.stop, Stop::kNone) << outcome.end.why;
    }
  }
}

// Answers, and ends with status 0 after three answers, or in place of an answer to a scene of more
// than one row.
std::vector<std::string> Restarting() {
  return {"/bin/sh", "-c",
          "while read word id width height rest; do\n"
          "  [ $height = 1 ] || exit 0\n"
          "  printf \"counts $id\\n0\\n\"\n"
          "  c=$((c + 1)); [ $c -lt 3 ] || exit 0\n"
          "done\n"};
}

TEST(ProcessSubject, BeginsAProgramAfreshThatEndsBetweenTwoAnswers) {
  ASSERT_TRUE(kIgnoresClosedPipes);
  using enum ProcessSubject::Program;
  std::vector<DrawJob> jobs(8);
  ProcessSubject theirs(Restarting(), Info(), {}, kTheUsers);
  const std::vector<DrawOutcome> outcomes = theirs.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), 8U);
  for (const DrawOutcome& outcome : outcomes) {
    EXPECT_EQ(outcome.end.stop, Stop::kNone) << outcome.end.why;
  }
  for (int n = 0; n < 4; ++n) EXPECT_EQ(SaidOf(theirs), "");
  Scene higher;
  higher.height = 2;
  jobs[1] = {higher, {}, 1};
  const std::vector<DrawOutcome> ended = theirs.DrawMany(jobs);
  ASSERT_EQ(ended.size(), 2U);
  EXPECT_EQ(ended[1].end.stop, Stop::kBrokeDown) << "a fresh one must answer first";
  EXPECT_TRUE(Has(ended[1].end.why, "ended with status 0")) << ended[1].end.why;
  ProcessSubject ours(Restarting(), Info());
  EXPECT_EQ(ours.DrawMany(std::vector<DrawJob>(8)).back().end.stop, Stop::kBrokeDown)
      << "the host of a plugin never ends by design";
}

TEST(ProcessSubject, WaitsNoLongerThanItsDeadline) {
  ProcessSubject subject(Pausing("sleep 1000"), Info(), {.seconds = 1000});
  subject.SetDeadline(ProcessSubject::Clock::now() + std::chrono::milliseconds(50));
  const std::string said = SaidOf(subject);
  EXPECT_TRUE(said.starts_with("slow: it ran out of time")) << said;
  EXPECT_TRUE(SaidOf(subject).starts_with("slow: it ran out of time"))
      << "it is over for what follows, too";
  ProcessSubject quick(Pausing(":"), Info());
  quick.SetDeadline(ProcessSubject::Clock::now());
  EXPECT_TRUE(SaidOf(quick).starts_with("slow: it ran out of time"));
  quick.SetDeadline(ProcessSubject::Clock::time_point::max());
  EXPECT_EQ(SaidOf(quick), "");
}

TEST(ProcessSubject, DoesNotFindOutWhatHangsIfTheDeadlineLeavesNoRoom) {
  ProcessSubject subject(Pausing("sleep 1000"), Info(), {.seconds = 0.05});
  subject.SetDeadline(ProcessSubject::Clock::now() + std::chrono::milliseconds(300));
  EXPECT_TRUE(SaidOf(subject).starts_with("slow: "));
}

TEST(ProcessSubject, DrawsASlowBatchInParts) {
  SubjectInfo info = Info();
  info.takes_batches = true;
  ProcessSubject subject(Pausing("sleep 0.1"), info, {.seconds = 0.5});
  const std::vector<DrawJob> jobs(8);
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), jobs.size());
  for (const DrawOutcome& outcome : outcomes) EXPECT_EQ(outcome.end.stop, Stop::kNone);
}

TEST(ProcessSubject, NamesTheOneOfABatchThatHangs) {
  SubjectInfo info = Info();
  info.takes_batches = true;
  ProcessSubject subject(Pausing("[ \"${rest%% *}\" = 1 ] || sleep 1000"), info, {.seconds = 0.15});
  std::vector<DrawJob> jobs(3);
  EXPECT_EQ(subject.DrawMany(jobs).size(), 3U);
  Scene higher;
  higher.height = 2;
  jobs[1] = {higher, {}, 1};
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), 2U) << "what follows a breakdown is left open";
  EXPECT_EQ(outcomes[0].end.stop, Stop::kNone);
  EXPECT_TRUE(IsBreakdown(outcomes[1].end.stop));
}

TEST(ProcessSubject, IsNotGivenTargetsThatNobodyTakes) {
  ProcessSubject subject(Pausing(":"), Info());
  Scene wide;
  wide.width = 16384;
  wide.height = 16384;
  const DrawJob large(wide, {}, 4);
  const std::array<DrawJob, 3> jobs{DrawJob{}, large, DrawJob{}};
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[1].end.stop, Stop::kNotDrawable);
  EXPECT_EQ(outcomes[2].end.stop, Stop::kNone);
}

// Answers two questions once it was asked both, "2" and "3"; alone, any.
std::vector<std::string> Valuing(const std::string& before_any) {
  return {
      "/bin/sh", "-c",
      "while read word first rest; do\n" + before_any +
          "\n"
          "  case \"$rest\" in\n"
          "    *' 1') read word second rest; printf \"values $first 2\\nvalues $second 3\\n\" ;;\n"
          "    *) printf \"values $first 4\\n\" ;;\n"
          "  esac\n"
          "done\n"};
}

SubjectInfo EdgeInfo() {
  SubjectInfo info = Info();
  info.edges.shows_values = true;
  return info;
}

TEST(ProcessSubject, PutsManyEdgeQuestionsBeforeItReadsTheFirstAnswer) {
  const ProcessSubject subject(Valuing(""), EdgeInfo(), {.seconds = 1});
  const std::array<EdgeQuestion, 3> questions{
      {{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {0, 2}}, {{0, 0}, {1, 0}, {0, 3}}}};
  EXPECT_EQ(subject.Edges()->Values(questions), (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(subject.Edges()->Value({0, 0}, {1, 0}, {0, 5}), 4);
  EXPECT_TRUE(subject.Edges()->Values({}).empty());
}

TEST(ProcessSubject, TellsWhenOneOfManyEdgeQuestionsIsNotAnswered) {
  const ProcessSubject subject(Valuing("[ \"${rest##* }\" != 7 ] || exit 3"), EdgeInfo());
  const std::array<EdgeQuestion, 2> questions{{{{0, 0}, {1, 0}, {0, 6}}, {{0, 0}, {1, 0}, {0, 7}}}};
  EXPECT_THROW(subject.Edges()->Values(questions), SubjectStop);
  EXPECT_EQ(subject.Edges()->Values({questions.data(), 1}), std::vector<double>{4})
      << "what follows a fault is asked afresh";
}

}  // namespace
}  // namespace rasterproof::subjects
