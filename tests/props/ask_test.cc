// Properties ask, and judge answers: without a subject, by a gate that is data, lazily.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/evaluators.h"
#include "core/question.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "subjects/builtin/builtin.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

Case OneTriangle() {
  Case c;
  c.scene.width = 8;
  c.scene.height = 8;
  c.scene.vertices = {{0.5, 0.5}, {7.5, 1.5}, {2.5, 6.5}};
  c.scene.triangles = {{0, 1, 2}};
  return c;
}

TEST(Asking, ForNewCoverageNeedsAMoveThatChangesIt) {
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin("spans-exact");
  const Description description{subject->Info(), nullptr, nullptr};
  const Property& property = *FindProperty("NewVerticesGiveNewCoverage");
  Case c = OneTriangle();
  EXPECT_EQ(property.ask(PlacedCase(c), description).checks.size(), 1U)
      << "a vertex lies on a sample";
  for (Vertex& v : c.scene.vertices) v.x -= 100;
  const Checks asked = property.ask(PlacedCase(c), description);
  EXPECT_TRUE(asked.checks.empty()) << "no move brings it into the target";
  EXPECT_EQ(asked.otherwise.outcome, Outcome::kNotExercised);
}

// ---- judging without a subject ------------------------------------------------------------------

struct AnswersJudged {
  std::size_t asked = 0;
  Verdict as_answered;
  Verdict one_sign_turned;
};

// The property about signs, judged by the values of a method and by the same with one sign turned.
AnswersJudged SignsOf(const std::string& method) {
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin(method);
  const Description description{subject->Info(), subject->Edges(), nullptr};
  const PlacedCase c(OneTriangle());
  const Checks asked = FindProperty("EdgeSignIsRightOutsideItsBand")->ask(c, description);
  const Check& check = asked.checks.front();
  Answers answers;
  for (const EdgeQuestion& q : check.questions.edges) {
    answers.edges.push_back(subject->Edges()->Value(q.a, q.b, q.p));
  }
  AnswersJudged judged{answers.edges.size(), check.judge(answers), {}};
  for (double& value : answers.edges) {
    if (value <= 1) continue;
    value = -value;
    break;
  }
  judged.one_sign_turned = check.judge(answers);
  return judged;
}

TEST(AJudgement, NeedsAnswersAndNoSubject) {
  const AnswersJudged judged = SignsOf("f32-direct");
  EXPECT_GT(judged.asked, 10U);
  EXPECT_EQ(judged.as_answered.outcome, Outcome::kHolds) << judged.as_answered.message;
  EXPECT_EQ(judged.one_sign_turned.outcome, Outcome::kViolated);
}

// ---- the gate -----------------------------------------------------------------------------------

TEST(TheGate, LetsNoCaseThroughThatItRefusesTheSubject) {
  std::size_t refused = 0;
  for (const std::string& name : subjects::BuiltinNames()) {
    const std::unique_ptr<Subject> subject = subjects::MakeBuiltin(name);
    const Description description{subject->Info(), subject->Edges(), subject->Barycentrics()};
    for (const Property& property : Catalog()) {
      if (!DoesNotApply(property.gate, description)) continue;
      ++refused;
      if (DomainsFor(subject->Info(), property).empty()) continue;
      for (std::uint64_t i = 0; i < 3; ++i) {
        const Case c = DrawCase(subject->Info(), property, kDefaultSeed, i);
        EXPECT_EQ(RunCase(*subject, property, c).outcome, Outcome::kNotApplicable)
            << name << " " << property.name << " " << c.origin;
      }
    }
  }
  EXPECT_GT(refused, 100U);
}

// A quotient that fits no grid point: what asks the oracle is not applicable, and draws nothing;
// what compares draws is judged.
TEST(TheGate, ToldByTheOracleWhatItDoesNotDecide) {
  SubjectInfo info = testing::SnappedInfo(8);
  info.takes_clip = true;
  info.profile.coordinate_limit = 0x1p60;
  int draws = 0;
  FakeSubject subject(info, [&](const Scene&, const DrawOptions&, CoverageCounts&) { ++draws; });
  Case c = OneTriangle();
  c.scene.clip_space = true;
  c.scene.vertices[1].x = 0x1p50;
  c.profile = info.profile;
  const Verdict model = RunCase(subject, *FindProperty("ClipSpaceCoverageEqualsTheModel"), c);
  EXPECT_EQ(model.outcome, Outcome::kNotApplicable);
  EXPECT_NE(model.message.find("does not fit 51 bits"), std::string::npos) << model.message;
  EXPECT_EQ(draws, 0);
  const Verdict turned = RunCase(subject, *FindProperty("VertexRotationKeepsCoverage"), c);
  EXPECT_EQ(turned.outcome, Outcome::kHolds) << turned.message;
  EXPECT_NE(draws, 0);
}

TEST(TheGate, IsToldInWords) {
  EXPECT_EQ(WordsOf(FindProperty("CoverageEqualsTheModel")->gate),
            "contract sample-exact; no grid points or tie rule left free; window space; "
            "coordinates within the limits; no corner outside guard_band; a scene that the oracle "
            "decides");
  EXPECT_EQ(WordsOf(FindProperty("DrawStaysInsideItsTarget")->gate),
            "every scene that the subject takes");
}

// ---- the runner ---------------------------------------------------------------------------------

Property WithChecks(Checks (*ask)(const PlacedCase&, const Description&)) {
  Property property = testing::ModelProperty({});
  property.ask = ask;
  return property;
}

Check OneDraw(const PlacedCase& c, Verdict verdict) {
  Check check;
  check.questions.draws.push_back(CountsOf(c.scene, c.profile, c.options));
  check.judge = [verdict = std::move(verdict)](const Answers&) { return verdict; };
  return check;
}

TEST(Checks, AreJudgedInOrderUpToTheFirstViolatedOne) {
  int draws = 0;
  FakeSubject subject(testing::RealInfo(),
                      [&](const Scene&, const DrawOptions&, CoverageCounts&) { ++draws; });
  const Property property = WithChecks([](const PlacedCase& c, const Description&) {
    Checks asked;
    asked.checks = {OneDraw(c, Verdict::Held(3)), OneDraw(c, Verdict::Violated(2, "wrong", {})),
                    OneDraw(c, Verdict::Held(100))};
    return asked;
  });
  const Verdict verdict = RunCase(subject, property, OneTriangle());
  EXPECT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.message, "wrong");
  EXPECT_EQ(verdict.exercised, 5U);
  EXPECT_EQ(draws, 2);
}

TEST(Checks, ReadTheDrawsThatTheyNameAsBases) {
  FakeSubject subject = testing::Sound(testing::RealInfo());
  const Property property = WithChecks([](const PlacedCase& c, const Description&) {
    Checks asked;
    asked.checks.push_back(BaseDraw(CountsOf(c.scene, c.profile, c.options)));
    Check second = OneDraw(c, {});
    second.bases = {0};
    second.judge = [](const Answers& answers) {
      if (answers.draws.size() != 2) return Verdict::Violated(1, "no base", {});
      return SameCounts(answers.draws[0]->counts, answers.draws[1]->counts, 7, "the base");
    };
    asked.checks.push_back(std::move(second));
    return asked;
  });
  const Verdict verdict = RunCase(subject, property, OneTriangle());
  EXPECT_EQ(verdict.outcome, Outcome::kHolds) << verdict.message;
  EXPECT_EQ(verdict.exercised, 7U);
}

TEST(Samples, ThatAreNotJudgedAreAddedUp) {
  FakeSubject subject = testing::Sound(testing::RealInfo());
  Property property = testing::ModelProperty(FindProperty("CoverageEqualsTheModel")->domains);
  property.ask = [](const PlacedCase&, const Description&) {
    return OneCheck({}, [](const Answers&) {
      Verdict verdict = Verdict::Held(1);
      verdict.not_judged = 3;
      return verdict;
    });
  };
  EXPECT_EQ(RunCampaign(subject, property, {.cases = 20}).not_judged, 60U);
}

// A length is the root of squares: of a side that is too short or too long for its precision they
// are no numbers, and the bound says nothing.
TEST(HeightDistances, AreJudgedWhereTheSquaresOfASideAreNumbers) {
  const Property& property = *FindProperty("HeightDistanceIsTheDistanceInPixels");
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin("f64-direct");
  Case c = OneTriangle();
  c.scene.precision = Precision::kFloat64;
  const std::uint64_t of_all = RunCase(*subject, property, c).exercised;
  c.scene.height = 13;
  c.scene.vertices = {{0, 0}, {-0x0.0000000000004p-1022, -0x0.0000000000006p-1022}, {15, 1}};
  const Verdict of_short_side = RunCase(*subject, property, c);
  EXPECT_NE(of_short_side.outcome, Outcome::kViolated) << of_short_side.message;
  EXPECT_GT(of_all, 0U);
  EXPECT_EQ(of_all % 3, 0U) << "all three sides";
}

}  // namespace
}  // namespace rasterproof::props
