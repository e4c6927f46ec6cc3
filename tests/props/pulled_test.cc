// What is pulled is what a direct run finds, bit for bit, whatever is saved and loaded meanwhile.
#include "props/engine/pulled.h"

#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "io/case_file.h"
#include "props/cause/cause_text.h"
#include "props/engine/pulled_causes.h"
#include "props/engine/pulled_infer.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kPulledCases = 20;

// A subject as one that is reached by its answers alone: what it draws is added to targets here.
class AtAFarEnd final : public Subject {
 public:
  explicit AtAFarEnd(const std::string& name)
      : subject_(subjects::IsMutant(name) ? subjects::MakeMutant(name)
                                          : subjects::MakeBuiltin(name)) {}
  const SubjectInfo& OwnInfo() const override { return subject_->OwnInfo(); }
  bool SharesCalls() const override { return true; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    drawn_ += jobs.size();
    std::vector<DrawOutcome> outcomes;
    for (const DrawJob& job : jobs) {
      DrawJob alone = job;
      alone.onto = nullptr;
      outcomes.push_back(std::move(subject_->DrawMany({&alone, 1}).front()));
      if (outcomes.back().end.stop == Stop::kNone && job.onto) {
        outcomes.back().drawing.counts += *job.onto;
      }
      if (EndsTheCall(outcomes.back().end.stop)) break;
    }
    return outcomes;
  }
  std::uint64_t drawn() const { return drawn_; }

 private:
  std::unique_ptr<Subject> subject_;
  std::uint64_t drawn_ = 0;
};

constexpr int kMostRounds = 200;

// Pulls to the end. Returns the number of rounds.
int Pull(PulledEngine& engine, Subject& subject) {
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<DrawJob>& jobs = engine.Next();
    if (jobs.empty()) return round;
    EXPECT_TRUE(engine.Answer(subject.DrawMany(jobs)));
  }
  ADD_FAILURE() << "there is no end";
  return kMostRounds;
}

std::string TextOf(const Case& c) { return io::CaseToJson({c, "", ""}); }

void ExpectSame(const Verdict& a, const Verdict& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.exercised, b.exercised);
  EXPECT_EQ(a.worst_ratio, b.worst_ratio);
  ASSERT_EQ(a.witness.has_value(), b.witness.has_value());
  if (!a.witness) return;
  EXPECT_EQ(a.witness->x, b.witness->x);
  EXPECT_EQ(a.witness->y, b.witness->y);
  EXPECT_EQ(TextOfValue(a.witness->observed), TextOfValue(b.witness->observed));
  EXPECT_EQ(TextOfValue(a.witness->expected), TextOfValue(b.witness->expected));
}

void ExpectSame(const Counterexample& a, const Counterexample& b) {
  EXPECT_EQ(TextOf(a.value), TextOf(b.value));
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.evaluations, b.evaluations);
  ExpectSame(a.verdict, b.verdict);
}

void ExpectSame(const PropertyResult& a, const PropertyResult& b) {
  SCOPED_TRACE(a.property + " of " + a.subject);
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.cases, b.cases);
  EXPECT_EQ(a.exercised, b.exercised);
  EXPECT_EQ(a.cases_refused, b.cases_refused);
  EXPECT_EQ(a.worst_ratio, b.worst_ratio);
  EXPECT_EQ(a.tiers, b.tiers);
  EXPECT_EQ(a.end, b.end);
  ASSERT_EQ(a.counterexample.has_value(), b.counterexample.has_value());
  if (a.counterexample) ExpectSame(*a.counterexample, *b.counterexample);
}

CampaignOptions Options() {
  CampaignOptions options;
  options.cases = kPulledCases;
  options.shrink_budget = 300;
  options.now = [] { return std::chrono::steady_clock::time_point(); };
  return options;
}

// Of what runs the whole catalogue.
CampaignOptions FewOptions() {
  CampaignOptions options = Options();
  options.cases = Cases(options.cases);
  options.shrink_budget = Cases(options.shrink_budget);
  return options;
}

InferOptions FewChecks() {
  InferOptions options;
  options.checks = Cases(options.checks);
  options.nearest_checks = Cases(options.nearest_checks);
  return options;
}

const Property& Named(std::string_view name) { return *FindProperty(std::string(name)); }

class PulledTest : public ::testing::TestWithParam<std::string> {};

TEST_P(PulledTest, ChecksAsARunDoes) {
  AtAFarEnd far(GetParam());
  PulledEngine engine(far.Info(), {20'000, std::size_t{1} << 27U});
  std::vector<const PulledCheck*> checks;
  std::vector<const Property*> properties;
  // Sanitized, each property of one of the subjects.
  constexpr std::size_t kEvery = kOneCaseIn > 1 ? 3 : 1;
  std::size_t number = GetParam().size();
  for (const Property& property : Catalog()) {
    if (property.is_about_sequence || property.takes_long || number++ % kEvery != 0) continue;
    properties.push_back(&property);
    checks.push_back(&engine.Add(std::make_unique<PulledCheck>(property, FewOptions())));
  }
  Pull(engine, far);
  for (std::size_t k = 0; k < checks.size(); ++k) {
    ExpectSame(checks[k]->result(), RunCampaign(far, *properties[k], FewOptions()));
  }
}

INSTANTIATE_TEST_SUITE_P(Subjects, PulledTest,
                         ::testing::Values("spans-exact", "f32-direct", "mutant:ties-inclusive",
                                           "mutant:vulkan-depth-off"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name) c = std::isalnum(c) != 0 ? c : '_';
                           return name;
                         });

TEST(PulledEngine, GoesOnFromWhatItSaved) {
  AtAFarEnd far("mutant:ties-inclusive");
  const Property& property = Named("SharedEdgeSamplesAreCoveredOnce");
  const RoundSize small{300, std::size_t{1} << 20U};
  std::string saved;
  std::unique_ptr<PulledEngine> engine;
  const PulledCheck* check = nullptr;
  int rounds = 0;
  for (; rounds < kMostRounds; ++rounds) {
    engine = std::make_unique<PulledEngine>(far.Info(), small);
    check = &engine->Add(std::make_unique<PulledCheck>(property, Options()));
    if (!saved.empty()) engine->load(saved);
    const std::vector<DrawJob>& jobs = engine->Next();
    if (jobs.empty()) break;
    EXPECT_TRUE(engine->Answer(far.DrawMany(jobs)));
    saved = engine->save();
  }
  EXPECT_GT(rounds, 3);
  ExpectSame(check->result(), RunCampaign(far, property, Options()));
  EXPECT_THROW(engine->load("something else"), InputError);
  EXPECT_THROW(engine->load(std::string_view(saved).substr(0, saved.size() - 1)), InputError);
  EXPECT_EQ(engine->save(), saved);
}

TEST(PulledEngine, TakesNoAnswerOfAnotherShape) {
  DrawOutcome outcome;
  outcome.drawing.counts = CoverageCounts(4, 3, 2);
  outcome.drawing.depths.resize(24);
  ASSERT_TRUE(ReadOutcome(OutcomeBytes(outcome)));
  EXPECT_EQ(ReadOutcome(OutcomeBytes(outcome))->drawing.counts.size(), 24U);
  for (int* const side : {&outcome.drawing.counts.width, &outcome.drawing.counts.samples}) {
    ++*side;
    EXPECT_FALSE(ReadOutcome(OutcomeBytes(outcome)));
    --*side;
  }
  outcome.drawing.depths.pop_back();
  EXPECT_FALSE(ReadOutcome(OutcomeBytes(outcome)));
}

TEST(PulledEngine, KeepsValuesOfEachChannelAndSample) {
  DrawOutcome outcome;
  Drawing& drawing = outcome.drawing;
  drawing.counts = CoverageCounts(4, 3, 2);
  drawing.values.assign(2 * 24, 0.1);
  drawing.values[47] = -0.0;
  drawing.derivatives.assign(2 * 24, {0.2, 1e300});
  const auto read = [&] { return ReadOutcome(OutcomeBytes(outcome)); };
  ASSERT_TRUE(read());
  EXPECT_EQ(read()->drawing.values, drawing.values);
  EXPECT_TRUE(std::signbit(read()->drawing.values[47]));
  EXPECT_EQ(read()->drawing.derivatives, drawing.derivatives);
  drawing.derivatives.pop_back();
  EXPECT_FALSE(read());
  drawing.derivatives.clear();
  drawing.values.pop_back();
  EXPECT_FALSE(read());
  drawing.values.assign(65 * 24, 0);
  EXPECT_FALSE(read());
}

TEST(PulledEngine, KeepsNumbersWhereATriangleIsShownAsShortAsTheyAre) {
  DrawOutcome outcome;
  Drawing& drawing = outcome.drawing;
  drawing.counts = CoverageCounts(40, 30, 1);
  drawing.primitive_ids.assign(1200, kNoPrimitive);
  drawing.primitive_ids[7] = drawing.primitive_ids[1199] = 0;
  drawing.values.assign(2 * 1200, 0.1);
  for (const std::size_t k : {14U, 15U, 2398U}) drawing.values[k] = 0x1.8p-140;
  drawing.values[2399] = std::numeric_limits<double>::quiet_NaN();
  const auto read = [&] { return ReadOutcome(OutcomeBytes(outcome))->drawing.values; };
  std::vector<double> shown(2 * 1200);
  const auto expect_kept = [&] {
    for (const std::size_t k : {14U, 15U, 2398U, 2399U}) shown[k] = drawing.values[k];
    const std::vector<double> kept = read();
    ASSERT_EQ(kept.size(), shown.size());
    EXPECT_EQ(std::memcmp(kept.data(), shown.data(), sizeof(double) * shown.size()), 0);
  };
  expect_kept();
  const std::size_t of_floats = OutcomeBytes(outcome).size();
  EXPECT_LT(of_floats, 64U);
  drawing.values[15] = 0.1;  // no float
  expect_kept();
  EXPECT_EQ(OutcomeBytes(outcome).size(), of_floats + 4 * sizeof(float));
  // No more memory than the bytes are worth.
  std::string damaged = OutcomeBytes(outcome);
  for (std::size_t k = 0; k + 1 < damaged.size(); ++k) {
    if (damaged.compare(k, 2, "\xe0\x12") != 0) continue;  // 2400
    damaged.replace(k, 2, "\xff\xff\xff\xff\xff\x7f");
    EXPECT_FALSE(ReadOutcome(damaged));
    return;
  }
  FAIL() << "no number of values";
}

TEST(PulledEngine, TellsJobsApartByTheChannelsThatTheyWant) {
  KnownAnswers answers({}, {});
  Scene scene;
  scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
  scene.triangles = {{0, 1, 2}};
  scene.channels = {{.name = "u", .values = {0, 0, 1}}};
  DrawJob job(scene, {}, 1);
  job.wants.values = true;
  EXPECT_TRUE(answers.Learn(job, {}));
  const auto times = [&](auto change) {
    Scene changed = scene;
    DrawJob other = job;
    change(changed, other.wants);
    other.scene = std::make_shared<const Scene>(changed);
    return answers.TimesAnswered(other);
  };
  EXPECT_EQ(times([](Scene&, Outputs&) {}), 1);
  EXPECT_EQ(times([](Scene& s, Outputs&) { s.channels[0].values[1] = -0.0; }), 0);
  EXPECT_EQ(times([](Scene& s, Outputs&) { s.channels[0].name = "v"; }), 0);
  EXPECT_EQ(times([](Scene& s, Outputs&) { s.channels[0].at = EvaluatedAt::kCentre; }), 0);
  EXPECT_EQ(times([](Scene&, Outputs& wants) { wants.derivatives = true; }), 0);
  EXPECT_EQ(times([](Scene&, Outputs& wants) { wants.values = false; }), 0);
}

TEST(PulledEngine, ShrinksAsReplayDoes) {
  AtAFarEnd far("mutant:ties-inclusive");
  const Property& property = Named("CoverageEqualsTheModel");
  Case failing;
  for (std::uint64_t n = 0;; ++n) {
    failing = DrawCase(far.Info(), property, 7, n);
    if (TryCase(far, property, failing).verdict.outcome == Outcome::kViolated) break;
  }
  PulledEngine engine(far.Info());
  const PulledShrink& shrink =
      engine.Add(std::make_unique<PulledShrink>(property, failing, Options()));
  EXPECT_LE(Pull(engine, far), 15);
  ExpectSame(shrink.result(), ShrinkFailing(far, property, failing, Options()));
}

TEST(PulledEngine, FindsTheCausesThatADirectSearchFinds) {
  AtAFarEnd far("mutant:snap-truncates");
  const PropertyResult result = RunCampaign(far, Named("CoverageEqualsTheModel"), Options());
  const std::vector<FailedProperty> failures{FailedBy(result, far.Info()).value()};
  bool is_known = false;
  PulledEngine engine(far.Info());
  const PulledCauses& pulled = engine.Add(std::make_unique<PulledCauses>(
      [&] { return std::exchange(is_known, true) ? std::optional(failures) : std::nullopt; }));
  EXPECT_TRUE(engine.Next().empty());
  EXPECT_LE(Pull(engine, far), 10);
  const Causes direct = FindCauses(
      [] { return std::make_unique<AtAFarEnd>("mutant:snap-truncates"); }, failures, 1000);
  ASSERT_EQ(pulled.result().all.size(), 1U);
  ASSERT_EQ(direct.all.size(), 1U);
  EXPECT_EQ(NameOfCause(pulled.result().all[0]), "truncation");
  EXPECT_EQ(CauseText(pulled.result().all[0], pulled.result()), CauseText(direct.all[0], direct));
}

TEST(PulledEngine, InfersAsInferDoes) {
  for (const std::string name : {"spans-exact", "mutant:ties-inclusive"}) {
    // Sanitized, SaysThatAnAnswerChanged draws what the mutant is asked for.
    if (kOneCaseIn > 1 && name != "spans-exact") continue;
    SCOPED_TRACE(name);
    AtAFarEnd far(name);
    PulledEngine engine(far.Info());
    const PulledInfer& pulled = engine.Add(std::make_unique<PulledInfer>(FewChecks()));
    EXPECT_LE(Pull(engine, far), 10);
    const Inference direct = Infer(far, FewChecks());
    EXPECT_EQ(pulled.result().remaining, direct.remaining);
    EXPECT_EQ(pulled.result().message, direct.message);
    EXPECT_EQ(pulled.result().experiments, direct.experiments);
    EXPECT_EQ(pulled.result().models, direct.models);
    const auto& [a, b] = std::pair(pulled.result().against_stated, direct.against_stated);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(TextOf(*a), TextOf(*b));
    }
  }
}

TEST(PulledEngine, AsksManyCasesInOneRoundAndEachOnce) {
  AtAFarEnd far("spans-exact");
  const Property& property = Named("CoverageEqualsTheModel");
  PulledEngine engine(far.Info());
  const PulledCheck& check = engine.Add(std::make_unique<PulledCheck>(property, Options()));
  EXPECT_EQ(engine.progress().done, 0U);
  EXPECT_LE(Pull(engine, far), 2);
  EXPECT_EQ(engine.progress().done, kPulledCases);
  const std::uint64_t pulled = far.drawn();
  RunCampaign(far, property, Options());
  EXPECT_LE(pulled, far.drawn() - pulled);
  EXPECT_EQ(check.result().outcome, Outcome::kHolds);
}

TEST(PulledEngine, SaysThatAnAnswerChanged) {
  AtAFarEnd far("mutant:ties-inclusive");  // not what it states: more than one round
  PulledEngine engine(far.Info());
  engine.Add(std::make_unique<PulledInfer>(FewChecks()));
  bool is_the_same = true;
  for (int round = 0; round < 3 && is_the_same; ++round) {
    std::vector<DrawOutcome> outcomes = far.DrawMany(engine.Next());
    for (DrawOutcome& outcome : outcomes) {
      for (std::uint32_t& count : outcome.drawing.counts.front) count += round == 0 ? 0U : 1U;
    }
    is_the_same = engine.Answer(outcomes);
  }
  EXPECT_FALSE(is_the_same);
}

TEST(PulledEngine, DoesNotJudgeTheOrderOfCalls) {
  AtAFarEnd far("spans-exact");
  PulledEngine engine(far.Info());
  const PulledCheck& check =
      engine.Add(std::make_unique<PulledCheck>(Named("EarlierScenesLeaveNoTrace"), Options()));
  EXPECT_TRUE(engine.Next().empty());
  EXPECT_EQ(check.result().outcome, Outcome::kNotApplicable);
}

}  // namespace
}  // namespace rasterproof::props
