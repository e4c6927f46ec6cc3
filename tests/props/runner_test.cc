// Subjects that throw, refuse, hang or change their answers; faults that are not the subject's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "props/judging/redraw.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "props/run/tally.h"
#include "props/run/trial.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;
using testing::ModelProperty;
using testing::PlantedSubject;
using testing::RealInfo;

constexpr std::array<std::string_view, 3> kDomains{"uniform-subpixel", "fans", "needles"};

void DrawRight(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  counts += exact::Coverage(scene, Profile{}, options);
}

SubjectStop Refusal() { return {Stop::kRefused, "it refused the scene"}; }

Case SomeCase() { return DrawCase(RealInfo(), ModelProperty(kDomains), kDefaultSeed, 0); }

bool Says(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

// ---- faults of ours -----------------------------------------------------------------------------

Property Throwing(Asked (*ask)(const Case&, const Description&)) {
  Property property = ModelProperty(kDomains);
  property.ask = ask;
  return property;
}

Asked OracleFails(const Case& c, const Description& /*subject*/) {
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, c.options));
  return OneCheck(std::move(questions), [](const Answers&) -> Verdict {
    throw std::domain_error("a rational must be finite");
  });
}

// What the oracle does not decide the gate says before it is asked.
Asked OracleDecidesNothing(const Case& /*c*/, const Description& /*subject*/) {
  throw InputError("scene", "the oracle decides no such thing", "give another");
}

Asked MemoryRunsOut(const Case& /*c*/, const Description& /*subject*/) { throw std::bad_alloc(); }

std::string FaultOf(Subject& subject, const Property& property) {
  try {
    RunCampaign(subject, property, {.cases = 40});
  } catch (const JudgingFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(AFaultOfOurs, IsNeverTheSubjects) {
  PlantedSubject subject(RealInfo(), DrawRight);
  const std::string said = FaultOf(subject, Throwing(OracleFails));
  EXPECT_TRUE(Says(said, "CoverageIsTheModels on uniform-subpixel:4140000@1")) << said;
  EXPECT_TRUE(Says(said, "a rational must be finite")) << said;
  EXPECT_NE(FaultOf(subject, Throwing(MemoryRunsOut)), "");
  EXPECT_NE(FaultOf(subject, Throwing(OracleDecidesNothing)), "");
  PlantedSubject outside = PlantedSubject::Outside(RealInfo(), DrawRight);
  EXPECT_NE(FaultOf(outside, Throwing(OracleFails)), "");
  EXPECT_NE(FaultOf(outside, Throwing(MemoryRunsOut)), "");
}

TEST(AFaultOfOurs, IsMemoryThatRanOutInTheSubjectAsWell) {
  const auto runs_out = [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw std::bad_alloc();
  };
  PlantedSubject subject(RealInfo(), runs_out);
  EXPECT_THROW(RunCase(subject, ModelProperty(kDomains), SomeCase()), JudgingFault);
  PlantedSubject outside = PlantedSubject::Outside(RealInfo(), runs_out);
  EXPECT_TRUE(Says(FaultOf(outside, ModelProperty(kDomains)), "uniform-subpixel:4140000@1 or one"));
}

TEST(ASubjectThatThrows, IsBlamedForWhatItsOwnCallThrows) {
  const auto throws = [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw std::logic_error("negative column");
  };
  PlantedSubject subject(RealInfo(), throws);
  PlantedSubject outside = PlantedSubject::Outside(RealInfo(), throws);
  for (Subject* const each : {static_cast<Subject*>(&subject), static_cast<Subject*>(&outside)}) {
    const Trial trial = TryCase(*each, ModelProperty(kDomains), SomeCase());
    EXPECT_EQ(trial.verdict.outcome, Outcome::kViolated);
    EXPECT_EQ(trial.stop, Stop::kBrokeDown);
    EXPECT_EQ(trial.verdict.message, "the subject failed: it threw: negative column");
  }
}

class ThrowingEdges final : public Subject, public EdgeEvaluator {
 public:
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    DrawRight(scene, options, counts);
  }
  const EdgeEvaluator* Edges() const override { return this; }
  double Value(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override {
    throw std::out_of_range("no such edge");
  }
  double ErrorBound(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override { return 1; }
  // NOLINTNEXTLINE
  std::vector<double> Steps(Point2, Point2, Point2, Step, int) const override { throw 7; }
  std::vector<double> SteppingErrorBounds(Point2, Point2, Point2, Step, int steps) const override {
    return std::vector<double>(static_cast<std::size_t>(steps) + 1, 1);
  }

 private:
  SubjectInfo info_ = RealInfo();
};

TEST(ASubjectThatThrows, IsBlamedForItsEdgeValuesToo) {
  ThrowingEdges subject;
  const Verdict value = RunCase(subject, *FindProperty("EdgeErrorStaysWithinItsBound"), SomeCase());
  EXPECT_EQ(value.outcome, Outcome::kViolated);
  EXPECT_EQ(value.message, "the subject failed: it threw: no such edge");
  const Property& bound = *FindProperty("SteppingStaysWithinItsBound");
  const Verdict verdict = RunCase(subject, bound, SomeCase());
  EXPECT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(verdict.message, "no std::exception")) << verdict.message;
}

// ---- refusals -----------------------------------------------------------------------------------

PlantedSubject::DrawFunction RefusingUnless(std::function<bool(const Scene&)> takes) {
  return [takes = std::move(takes)](const Scene& scene, const DrawOptions& options,
                                    CoverageCounts& counts) {
    if (!takes(scene)) throw Refusal();
    DrawRight(scene, options, counts);
  };
}

PropertyResult RunOutside(PlantedSubject::DrawFunction draw, const CampaignOptions& options) {
  PlantedSubject outside = PlantedSubject::Outside(RealInfo(), std::move(draw));
  return RunCampaign(outside, ModelProperty(kDomains), options);
}

PropertyResult RunInside(PlantedSubject::DrawFunction draw, const CampaignOptions& options) {
  PlantedSubject inside(RealInfo(), std::move(draw));
  return RunCampaign(inside, ModelProperty(kDomains), options);
}

TEST(Refusals, AreCountedAndWhatHoldsHoldsWhereItDidNotRefuse) {
  const auto takes = [](const Scene& scene) { return scene.width % 3 != 0; };
  const PropertyResult inside = RunInside(RefusingUnless(takes), {.cases = 120});
  EXPECT_EQ(inside.outcome, Outcome::kHolds) << inside.message;
  EXPECT_GT(inside.cases_refused, 10U);
  EXPECT_EQ(inside.cases_exercised + inside.cases_refused, 120U);
  EXPECT_EQ(inside.message, "holds where it did not refuse: exercised in " +
                                std::to_string(inside.cases_exercised) + " of 120 cases, " +
                                std::to_string(inside.cases_refused) + " refused");
  const PropertyResult outside = RunOutside(RefusingUnless(takes), {.cases = 120});
  EXPECT_EQ(outside.outcome, inside.outcome);
  EXPECT_EQ(outside.cases_refused, inside.cases_refused);
  EXPECT_EQ(outside.message, inside.message);
}

TEST(Refusals, OfMoreThanHalfAreNoVerdict) {
  const auto all_but_two = [] {
    return [n = 0](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) mutable {
      if (n++ >= 2) throw Refusal();
      DrawRight(scene, options, counts);
    };
  };
  for (const PropertyResult& result :
       {RunInside(all_but_two(), {.cases = 120}), RunOutside(all_but_two(), {.cases = 120})}) {
    EXPECT_EQ(result.outcome, Outcome::kInconclusive);
    EXPECT_EQ(result.cases_refused, 118U);
    EXPECT_TRUE(Says(result.message, "exercised in 2 of 120 cases, 118 refused")) << result.message;
    EXPECT_TRUE(Says(result.message, "it refused the scene")) << result.message;
  }
  const PropertyResult all =
      RunInside(RefusingUnless([](const Scene&) { return false; }), {.cases = 9});
  EXPECT_EQ(all.outcome, Outcome::kInconclusive);
}

TEST(Refusals, BeyondTheLimitsAreNoneTooMany) {
  const auto takes = [](const Scene& scene) { return WithinLimits(scene, RealInfo().profile); };
  PlantedSubject subject(RealInfo(), RefusingUnless(takes));
  const PropertyResult result =
      RunCampaign(subject, *FindProperty("NonFiniteTrianglesCoverNothing"), {.cases = 60});
  EXPECT_GT(result.cases_refused, 30U);
  EXPECT_EQ(result.outcome, Outcome::kNotExercised) << result.message;
}

TEST(Refusals, AreNoFailureOfASmallerCase) {
  const auto draw = [](const Scene& scene, const DrawOptions&, CoverageCounts& counts) {
    if (scene.width < 3) throw Refusal();
    counts.front[0] += 7;
  };
  const PropertyResult result = RunInside(draw, {.cases = 120});
  ASSERT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_EQ(result.counterexample->scene.width, 3);
  EXPECT_EQ(result.verdict->outcome, Outcome::kViolated);
}

TEST(Refusals, OfWhatCantBePutAreNotApplicable) {
  const auto draw = [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw InputError("scene", "it takes no such thing", "give another");
  };
  EXPECT_EQ(RunInside(draw, {.cases = 9}).outcome, Outcome::kNotApplicable);
}

// ---- answers that change ------------------------------------------------------------------------

TEST(AnAnswerThatChanges, IsInconclusiveWithBothAnswers) {
  const auto wrong_once = [n = 0](const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (n++ == 0) counts.front[0] += 5;
  };
  PlantedSubject subject(RealInfo(), wrong_once);
  const PropertyResult result =
      RunCampaign(subject, *FindProperty("CoverageEqualsTheModel"), {.cases = 5});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive);
  EXPECT_TRUE(Says(result.message, "not deterministic")) << result.message;
  EXPECT_TRUE(Says(result.message, "first violated: coverage differs")) << result.message;
  EXPECT_TRUE(Says(result.message, "at pixel (0, 0) observed front ")) << result.message;
  EXPECT_TRUE(Says(result.message, "; then holds")) << result.message;
  ASSERT_TRUE(result.counterexample && result.verdict);
  EXPECT_EQ(result.verdict->outcome, Outcome::kViolated);
}

TEST(AnAnswerThatChanges, IsOneInABatchThatNoBatchRepeats) {
  const auto wrong_once = [n = 0](const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (n++ == 3) counts.front[0] += 5;
  };
  const PropertyResult result = RunOutside(wrong_once, {.cases = 64});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive) << result.message;
  EXPECT_EQ(result.failing_case, "uniform-subpixel:4140001@1");
}

TEST(AnAnswerThatChanges, IsViolatedIfTheCaseThatFailedFirstFailsAgain) {
  // Always wrong on the scene that is drawn first, and a few times on others.
  const auto draw = [first = std::optional<Scene>(), n = 0](const Scene& scene,
                                                            const DrawOptions& options,
                                                            CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (!first) first = scene;
    if (scene == *first || ++n <= 3) counts.front[0] += 5;
  };
  const PropertyResult result = RunInside(draw, {.cases = 1});
  EXPECT_EQ(result.outcome, Outcome::kViolated) << result.message;
  EXPECT_TRUE(Says(result.message, "smaller cases fail only sometimes")) << result.message;
  EXPECT_EQ(result.counterexample->scene, SomeCase().scene);
}

TEST(AnAnswerThatChanges, ViolatesThePropertyThatEqualDrawsAreEqual) {
  const auto wrong_once = [n = 0](const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (n++ == 1) counts.front[0] += 5;
  };
  PlantedSubject subject(RealInfo(), wrong_once);
  const PropertyResult result =
      RunCampaign(subject, *FindProperty("EqualDrawsGiveEqualCounts"), {.cases = 5});
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(result.message, "not every time: first violated")) << result.message;
}

// ---- time ---------------------------------------------------------------------------------------

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

// Draws what is right, and takes its time over it.
class Timed final : public Subject {
 public:
  using Take = std::function<void(const Scene&, Time&)>;
  Timed(Time& time, Take take) : time_(time), take_(std::move(take)) {}
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    take_(scene, time_);
    DrawRight(scene, options, counts);
  }
  bool SharesCalls() const override { return true; }
  void SetDeadline(Clock::time_point deadline) override { time_.deadline = deadline; }

 private:
  SubjectInfo info_ = RealInfo();
  Time& time_;
  Take take_;
};

PropertyResult RunTimed(Time& time, Timed::Take take, CampaignOptions options) {
  Timed outside(time, std::move(take));
  options.now = [&time] { return time.now; };
  return RunCampaign(outside, ModelProperty(kDomains), options);
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
  EXPECT_TRUE(Says(result.message, "fans:4140016@1: no answer within 10 s; --time-limit"))
      << result.message;
  EXPECT_TRUE(Says(result.message, "nothing violated so far, exercised in 49 of 50 cases"))
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
  const std::vector<std::size_t> slow = SizesDrawn(2);
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
  EXPECT_TRUE(Says(result.message, "it gave no answer within 100 s")) << result.message;
  EXPECT_TRUE(Says(result.message, "smaller cases without an answer")) << result.message;
  EXPECT_EQ(result.verdict->outcome, Outcome::kViolated);
  EXPECT_LE(hanging.hangs, 1 + kMostHangs);
  EXPECT_LE(result.seconds, (11 + kMostHangs + 1) * Hanging::kLimit);
  EXPECT_TRUE(pace.hangs);

  // The next property that meets it costs one limit more, and convicts nobody.
  hanging.hangs = 0;
  const PropertyResult next = RunTimed(time, std::ref(hanging), options);
  EXPECT_EQ(next.outcome, Outcome::kInconclusive);
  EXPECT_TRUE(Says(next.message, "saw the subject hang")) << next.message;
  EXPECT_EQ(hanging.hangs, 1);
  EXPECT_LE(next.seconds, 1.5 * Hanging::kLimit);
}

TEST(AHang, IsNoCrashThatTookItsTime) {
  Time time;
  const auto crashes_once = [n = 0](const Scene&, Time& t) mutable {
    t.Work(11);
    if (++n == 3) BreakDown("it was killed by signal 6");
  };
  const PropertyResult result = RunTimed(time, crashes_once, {.cases = 9, .time_limit = 10});
  EXPECT_TRUE(Says(result.message, "not deterministic")) << result.message;
}

TEST(AHang, IsShrunkWithinTheRunsTime) {
  Time time;
  Hanging hanging;
  const PropertyResult result = RunTimed(
      time, std::ref(hanging), {.cases = 100, .seconds = 135, .time_limit = Hanging::kLimit});
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(result.message, "not shrunk any further: the time was up")) << result.message;
  EXPECT_LE(result.seconds, 135.1);
}

// ---- runs that are stopped ----------------------------------------------------------------------

TEST(ARunThatIsStopped, SaysWhatItKnowsSoFar) {
  int asked = 0;
  CampaignOptions options{.cases = 1000};
  options.stop = [&] { return ++asked > 7; };
  const PropertyResult inside = RunInside(DrawRight, options);
  EXPECT_EQ(inside.outcome, Outcome::kInconclusive);
  EXPECT_EQ(inside.message, "interrupted; nothing violated so far, exercised in 7 of 7 cases");
  asked = 0;
  const PropertyResult outside = RunOutside(DrawRight, options);
  EXPECT_EQ(outside.outcome, Outcome::kInconclusive);
  EXPECT_LT(outside.cases, 32U);
  EXPECT_TRUE(Says(outside.message, "interrupted")) << outside.message;
}

TEST(ARunThatIsStopped, WhileItShrinksIsViolatedAllTheSame) {
  bool shrinks = false;
  std::vector<std::uint64_t> told;
  CampaignOptions options{.cases = 1000};
  options.shrinking = [&](std::uint64_t evaluations) {
    told.push_back(evaluations);
    shrinks = evaluations >= 16;
  };
  options.stop = [&] { return shrinks; };
  const auto wrong = [](const Scene& scene, const DrawOptions& drawn, CoverageCounts& counts) {
    DrawRight(scene, drawn, counts);
    if (scene.triangles.size() > 1) counts.front[0] += 5;
  };
  const PropertyResult result = RunInside(wrong, options);
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(result.message, "not shrunk any further: interrupted")) << result.message;
  EXPECT_EQ(told.front(), 0U);
  EXPECT_EQ(told.back(), 16U);
}

TEST(ARunThatIsStopped, BlamesNoSubjectForWhatWasStoppedWithIt) {
  bool stopped = false;
  CampaignOptions options{.cases = 1000};
  options.stop = [&] { return stopped; };
  const auto killed = [&](const Scene&, const DrawOptions&, CoverageCounts&) {
    stopped = true;
    BreakDown("it was killed by signal 9");
  };
  EXPECT_EQ(RunInside(killed, options).outcome, Outcome::kInconclusive);
}

}  // namespace
}  // namespace rasterproof::props
