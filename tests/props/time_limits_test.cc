// Subjects that are slow or hang: what a run's time and a time limit cost and tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/call_end.h"
#include "exact/coverage.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;
using testing::ModelProperty;
using testing::RealInfo;

constexpr std::array<std::string_view, 3> kTimedDomains{"uniform-subpixel", "fans", "needles"};

bool HasWords(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

// A clock that nobody waits for, and the deadline that a subject was given.
struct Time {
  Clock::time_point now{};
  Clock::time_point deadline = Clock::time_point::max();

  void Pass(double seconds) {
    now += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  /// What a subject outside does: it works on, at most until its deadline.
  void Work(double seconds) {
    const auto began = now;
    Pass(seconds);
    if (now <= deadline) return;
    now = std::max(began, deadline);
    throw SubjectStop(Stop::kDeadline, "it was given no more time");
  }
};

using Take = std::function<void(const Scene&, Time&)>;

// Of a subject that draws what is right, and takes its time over it.
PropertyResult RunTimed(Time& time, const Take& take, CampaignOptions options) {
  FakeSubject outside = FakeSubject::Outside(
      RealInfo(), [&](const Scene& scene, const DrawOptions& draw, CoverageCounts& counts) {
        take(scene, time);
        counts += exact::Coverage(scene, Profile{}, draw);
      });
  outside.on_deadline = [&](Clock::time_point deadline) { time.deadline = deadline; };
  options.now = [&time] { return time.now; };
  return RunCampaign(outside, ModelProperty(kTimedDomains), options);
}

TEST(ASlowSubject, IsNeverViolatedForIt) {
  const auto slow_over_the_50th = [n = 0](const Scene&, Time& time) mutable {
    time.Pass(0.01);
    if (++n == 50)
      throw SubjectStop(Stop::kTooSlow, "no answer within 10 s; --time-limit gives it more");
  };
  Time time;
  const PropertyResult result = RunTimed(time, slow_over_the_50th, {.cases = 120});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive);
  EXPECT_EQ(result.cases, 50U);
  EXPECT_TRUE(HasWords(result.message, "fans:4140016@1: no answer within 10 s; --time-limit"))
      << result.message;
  EXPECT_TRUE(HasWords(result.message, "nothing violated so far, exercised in 49 of 50 cases"))
      << result.message;
}

TEST(ASlowSubject, IsGivenTheRunsDeadlineWithinACaseAndLosesItAfterwards) {
  Time time;
  const auto a_second = [](const Scene&, Time& t) { t.Work(1); };
  const PropertyResult result = RunTimed(time, a_second, {.cases = 1000, .seconds = 40.5});
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_EQ(result.cases, 40U);
  EXPECT_EQ(time.now, Clock::time_point{} + std::chrono::milliseconds(40500));
  EXPECT_EQ(time.deadline, Clock::time_point::max());
}

TEST(ASlowSubject, ThatTookAWholeTimeLimitIsTooSlowThoughTheRunsTimeWasUpToo) {
  Time time;
  const auto hangs_late = [n = 0](const Scene&, Time& t) mutable {
    t.Work(++n < 5 ? 0.01 : 10);
    if (n >= 5)
      throw SubjectStop(Stop::kTooSlow, "no answer within 10 s, and no time left to try it longer");
  };
  const PropertyResult result =
      RunTimed(time, hangs_late, {.cases = 1000, .seconds = 15, .time_limit = 10});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive) << result.message;
}

std::vector<std::size_t> SizesDrawn(double seconds) {
  Time time;
  std::vector<std::size_t> sizes;
  const auto take = [&](const Scene& scene, Time& t) {
    t.Work(seconds);
    sizes.push_back(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height) *
                    (1 + scene.triangles.size()));
  };
  RunTimed(time, take, {.cases = 64});
  return sizes;
}

TEST(ASlowSubject, GetsSmallCasesFirstAndAFastOneTheSameAsEver) {
  const std::vector<std::size_t> fast = SizesDrawn(0.001);
  const std::vector<std::size_t> slow = SizesDrawn(6);
  ASSERT_EQ(fast.size(), 64U);
  ASSERT_EQ(slow.size(), 64U);
  EXPECT_FALSE(std::is_sorted(fast.begin() + 32, fast.end()));
  EXPECT_TRUE(std::is_sorted(slow.begin() + 32, slow.end()));
  EXPECT_TRUE(std::is_permutation(fast.begin(), fast.end(), slow.begin()));
}

// Loops for ever over thin triangles: after one limit and ten more it is known to hang.
class Hanging {
 public:
  static constexpr double kLimit = 10;
  void operator()(const Scene& scene, Time& time) {
    time.Pass(0.001);
    if (scene.width < 3) return;
    ++hangs;
    time.Work(11 * kLimit);
    throw SubjectStop(Stop::kHung, "it gave no answer within 100 s");
  }
  int hangs = 0;
};

TEST(AHang, IsShrunkWithFewTimeLimitsAndEndsItsProperty) {
  Time time;
  Hanging hanging;
  Pace pace;
  const CampaignOptions options{.cases = 100, .time_limit = Hanging::kLimit, .pace = &pace};
  const PropertyResult result = RunTimed(time, std::ref(hanging), options);
  ASSERT_EQ(result.outcome, Outcome::kViolated) << result.message;
  EXPECT_TRUE(HasWords(result.message, "it gave no answer within 100 s")) << result.message;
  EXPECT_TRUE(HasWords(result.message, "smaller cases that did not answer")) << result.message;
  EXPECT_EQ(result.counterexample->verdict.outcome, Outcome::kViolated);
  EXPECT_LE(hanging.hangs, 1 + kMostHangs);
  EXPECT_LE(result.seconds, (11 + kMostHangLimits + 0.2) * Hanging::kLimit);
  EXPECT_TRUE(pace.hangs);

  // The next property that meets it convicts nobody. It costs a limit while nothing was answered,
  // and a tenth of it from the first answer on.
  for (const double share : {1.0, 0.1}) {
    hanging.hangs = 0;
    const PropertyResult next = RunTimed(time, std::ref(hanging), options);
    EXPECT_EQ(next.outcome, Outcome::kInconclusive);
    EXPECT_TRUE(HasWords(next.message, "after a hang")) << next.message;
    EXPECT_EQ(hanging.hangs, 1);
    EXPECT_LE(next.seconds, 1.1 * share * Hanging::kLimit);
    pace.Answered(0.001);
  }
}

TEST(AHang, OfASubjectThatNeverAnswersCostsOneLongLimitARun) {
  Time time;
  const auto hangs = [](const Scene&, Time& t) {
    t.Work(11 * Hanging::kLimit);
    throw SubjectStop(Stop::kHung, "it gave no answer within 100 s");
  };
  Pace pace;
  const CampaignOptions options{.cases = 100, .time_limit = Hanging::kLimit, .pace = &pace};
  double seconds = RunTimed(time, hangs, options).seconds;
  EXPECT_LE(seconds, (11 + kMostHangLimits) * Hanging::kLimit);
  constexpr int kProperties = 100;
  for (int n = 1; n < kProperties; ++n) {
    const PropertyResult next = RunTimed(time, hangs, options);
    EXPECT_EQ(next.outcome, Outcome::kInconclusive);
    seconds += next.seconds;
  }
  EXPECT_LE(seconds, (11 + kMostHangLimits + 2 + 0.1 * kProperties) * Hanging::kLimit);
}

TEST(AHang, LeavesASlowSubjectTenTimesWhatItNeeds) {
  Pace pace;
  EXPECT_EQ(pace.LimitAfterAHang(10), 10) << "nothing was asked yet";
  pace.silent = 3;
  EXPECT_EQ(pace.LimitAfterAHang(10), 1);
  pace.Answered(0.5);
  EXPECT_EQ(pace.LimitAfterAHang(10), 5);
  pace.Answered(0.001);
  EXPECT_EQ(pace.LimitAfterAHang(10), 5);
  pace.Answered(3);
  EXPECT_EQ(pace.LimitAfterAHang(10), 10);
}

TEST(AHang, IsNoCrashThatTookItsTime) {
  Time time;
  const auto crashes_once = [n = 0](const Scene&, Time& t) mutable {
    t.Work(11);
    if (++n == 3) BreakDown("it was killed by signal 6");
  };
  const PropertyResult result = RunTimed(time, crashes_once, {.cases = 9, .time_limit = 10});
  EXPECT_EQ(result.outcome, Outcome::kViolated) << "whatever ended a process is told";
  EXPECT_TRUE(HasWords(result.message, "killed by signal 6; it did not happen again"))
      << result.message;
  EXPECT_TRUE(HasWords(result.message, "not deterministic")) << result.message;
}

TEST(AHang, IsShrunkWithinTheRunsTime) {
  Time time;
  Hanging hanging;
  const PropertyResult result = RunTimed(
      time, std::ref(hanging), {.cases = 100, .seconds = 113, .time_limit = Hanging::kLimit});
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_TRUE(HasWords(result.message, "shrinking stopped: it ran out of time")) << result.message;
  EXPECT_LE(result.seconds, 113.1);
}

}  // namespace
}  // namespace rasterproof::props
