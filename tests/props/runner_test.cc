// Subjects that throw, refuse or change their answers; faults that are not the subject's.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "props/judging/redraw.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "props/run/trial.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::DrawRight;
using testing::ModelProperty;
using testing::RealInfo;

constexpr std::array<std::string_view, 3> kDomains{"uniform-subpixel", "fans", "needles"};

SubjectStop Refusal() { return {Stop::kRefused, "it refused the scene"}; }

Case SomeCase() { return DrawCase(RealInfo(), ModelProperty(kDomains), kDefaultSeed, 0); }

bool Says(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

// ---- faults of ours -----------------------------------------------------------------------------

Property Throwing(Checks (*ask)(const PlacedCase&, const Description&)) {
  Property property = ModelProperty(kDomains);
  property.ask = ask;
  return property;
}

Checks OracleFails(const PlacedCase& c, const Description& /*subject*/) {
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, c.options));
  return OneCheck(std::move(questions), [](const Answers&) -> Verdict {
    throw std::domain_error("a rational must be finite");
  });
}

// What the oracle does not decide the gate says before it is asked.
Checks OracleDecidesNothing(const PlacedCase& /*c*/, const Description& /*subject*/) {
  throw InputError("scene", "the oracle decides no such thing", "give another");
}

Checks MemoryRunsOut(const PlacedCase&, const Description&) { throw std::bad_alloc(); }

std::string FaultOf(Subject& subject, const Property& property) {
  try {
    RunCampaign(subject, property, {.cases = 40});
  } catch (const JudgingFault& fault) {
    return fault.what();
  }
  return "";
}

// Draws the case moved right by `Right` pixels, which no subject gets right.
template <int Right>
Checks DrawsMoved(const PlacedCase& c, const Description& /*subject*/) {
  Scene moved = c.scene;
  for (Vertex& v : moved.vertices) v.x += Right;
  Questions questions;
  questions.draws.push_back(CountsOf(moved, c.profile, c.options));
  return OneCheck(std::move(questions),
                  [](const Answers&) { return Verdict::Violated(1, "asked", Witness{}); });
}

TEST(AScenePropertiesMake, IsDrawnWithinTheLimitsAlone) {
  SubjectInfo info = RealInfo();
  info.profile.coordinate_limit = 4096;
  int draws = 0;
  FakeSubject subject(info,
                      [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                        ++draws;
                        DrawRight(scene, options, counts);
                      });
  Case c = SomeCase();
  c.profile = info.profile;
  Property property = ModelProperty(kDomains);
  property.gate.bound_by = BoundBy::kLimits;
  property.ask = DrawsMoved<5000>;
  const Verdict beyond = TryCase(subject, property, c).verdict;
  EXPECT_EQ(beyond.outcome, Outcome::kNotExercised);
  EXPECT_EQ(beyond.message,
            "the property's own scene is beyond the limits: a coordinate lies beyond the profile's "
            "coordinate_limit");
  EXPECT_EQ(draws, 0);
  property.ask = DrawsMoved<1000>;
  EXPECT_EQ(TryCase(subject, property, c).verdict.outcome, Outcome::kViolated);
  property.ask = DrawsMoved<5000>;
  property.gate.bound_by = BoundBy::kSizes;  // one that asks beyond it on purpose
  EXPECT_EQ(TryCase(subject, property, c).verdict.outcome, Outcome::kViolated);
  c.profile.max_target = {c.scene.width, c.scene.height - 1};
  const Verdict too_large = TryCase(subject, property, c).verdict;
  EXPECT_EQ(too_large.outcome, Outcome::kNotExercised);
  EXPECT_EQ(too_large.message, "the target is larger than the profile's max_target");
  property.gate.bound_by = BoundBy::kNothing;
  EXPECT_EQ(TryCase(subject, property, c).verdict.outcome, Outcome::kViolated);
}

TEST(AFaultOfOurs, IsNeverTheSubjects) {
  FakeSubject subject(RealInfo(), DrawRight);
  const std::string said = FaultOf(subject, Throwing(OracleFails));
  EXPECT_TRUE(Says(said, "CoverageIsTheModels on uniform-subpixel:4140000@1")) << said;
  EXPECT_TRUE(Says(said, "a rational must be finite")) << said;
  EXPECT_NE(FaultOf(subject, Throwing(MemoryRunsOut)), "");
  EXPECT_NE(FaultOf(subject, Throwing(OracleDecidesNothing)), "");
  FakeSubject outside = FakeSubject::Outside(RealInfo(), DrawRight);
  EXPECT_NE(FaultOf(outside, Throwing(OracleFails)), "");
  EXPECT_NE(FaultOf(outside, Throwing(MemoryRunsOut)), "");
}

TEST(AFaultOfOurs, IsMemoryThatRanOutInTheSubjectAsWell) {
  const auto runs_out = [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw std::bad_alloc();
  };
  FakeSubject subject(RealInfo(), runs_out);
  EXPECT_THROW(RunCase(subject, ModelProperty(kDomains), SomeCase()), JudgingFault);
  FakeSubject outside = FakeSubject::Outside(RealInfo(), runs_out);
  EXPECT_TRUE(Says(FaultOf(outside, ModelProperty(kDomains)), "uniform-subpixel:4140000@1 or one"));
}

TEST(ASubjectThatThrows, IsBlamedForWhatItsOwnCallThrows) {
  const auto throws = [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw std::logic_error("negative column");
  };
  FakeSubject subject(RealInfo(), throws);
  FakeSubject outside = FakeSubject::Outside(RealInfo(), throws);
  for (Subject* const each : {static_cast<Subject*>(&subject), static_cast<Subject*>(&outside)}) {
    const Trial trial = TryCase(*each, ModelProperty(kDomains), SomeCase());
    EXPECT_EQ(trial.verdict.outcome, Outcome::kViolated);
    EXPECT_EQ(trial.stop, Stop::kBrokeDown);
    EXPECT_EQ(trial.verdict.message, "the subject failed: it threw: negative column");
  }
}

class ThrowingEdges final : public EdgeEvaluator {
 public:
  double Value(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override {
    throw std::out_of_range("no such edge");
  }
  double ErrorBound(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) const override { return 1; }
  // NOLINTNEXTLINE
  std::vector<double> Steps(Point2, Point2, Point2, Step, int) const override { throw 7; }
  std::vector<double> SteppingErrorBounds(Point2, Point2, Point2, Step, int steps) const override {
    return std::vector<double>(static_cast<std::size_t>(steps) + 1, 1);
  }
};

TEST(ASubjectThatThrows, IsBlamedForItsEdgeValuesToo) {
  const ThrowingEdges edges;
  FakeSubject subject(RealInfo(), DrawRight);
  subject.edges = &edges;
  const Verdict value = RunCase(subject, *FindProperty("EdgeErrorStaysWithinItsBound"), SomeCase());
  EXPECT_EQ(value.outcome, Outcome::kViolated);
  EXPECT_EQ(value.message, "the subject failed: it threw: no such edge");
  const Property& bound = *FindProperty("SteppingStaysWithinItsBound");
  const Verdict verdict = RunCase(subject, bound, SomeCase());
  EXPECT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(verdict.message, "other than a std::exception")) << verdict.message;
}

// ---- refusals -----------------------------------------------------------------------------------

FakeSubject::DrawFunction RefusingUnless(std::function<bool(const Scene&)> takes) {
  return [takes = std::move(takes)](const Scene& scene, const DrawOptions& options,
                                    CoverageCounts& counts) {
    if (!takes(scene)) throw Refusal();
    DrawRight(scene, options, counts);
  };
}

PropertyResult RunOutside(FakeSubject::DrawFunction draw, const CampaignOptions& options) {
  FakeSubject outside = FakeSubject::Outside(RealInfo(), std::move(draw));
  return RunCampaign(outside, ModelProperty(kDomains), options);
}

PropertyResult RunInside(FakeSubject::DrawFunction draw, const CampaignOptions& options) {
  FakeSubject inside(RealInfo(), std::move(draw));
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
  FakeSubject subject(RealInfo(), RefusingUnless(takes));
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
  EXPECT_EQ(result.counterexample->value.scene.width, 3);
  EXPECT_EQ(result.counterexample->verdict.outcome, Outcome::kViolated);
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
  FakeSubject subject(RealInfo(), wrong_once);
  const PropertyResult result =
      RunCampaign(subject, *FindProperty("CoverageEqualsTheModel"), {.cases = 5});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive);
  EXPECT_TRUE(Says(result.message, "not deterministic")) << result.message;
  EXPECT_TRUE(Says(result.message, "first violated: coverage differs")) << result.message;
  EXPECT_TRUE(Says(result.message, "at pixel (0, 0) observed front ")) << result.message;
  EXPECT_TRUE(Says(result.message, "; then holds")) << result.message;
  ASSERT_TRUE(result.counterexample);
  EXPECT_EQ(result.counterexample->verdict.outcome, Outcome::kViolated);
}

TEST(AnAnswerThatChanges, IsOneInABatchThatNoBatchRepeats) {
  const auto wrong_once = [n = 0](const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (n++ == 3) counts.front[0] += 5;
  };
  const PropertyResult result = RunOutside(wrong_once, {.cases = 64});
  EXPECT_EQ(result.outcome, Outcome::kInconclusive) << result.message;
  EXPECT_EQ(result.counterexample->failing_case, "uniform-subpixel:4140001@1");
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
  EXPECT_EQ(result.counterexample->value.scene, SomeCase().scene);
}

TEST(AnAnswerThatChanges, ViolatesThePropertyThatEqualDrawsAreEqual) {
  const auto wrong_once = [n = 0](const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) mutable {
    DrawRight(scene, options, counts);
    if (n++ == 1) counts.front[0] += 5;
  };
  FakeSubject subject(RealInfo(), wrong_once);
  const PropertyResult result =
      RunCampaign(subject, *FindProperty("EqualDrawsGiveEqualCounts"), {.cases = 5});
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_TRUE(Says(result.message, "not every time: first violated")) << result.message;
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
  EXPECT_TRUE(Says(result.message, "shrinking stopped: interrupted")) << result.message;
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
