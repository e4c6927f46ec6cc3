// The catalogue judges: sound subjects hold, and each property can fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/call_end.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/authority.h"
#include "props/domains/domain.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/fake_subject.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::DrawRight;

constexpr std::uint64_t kSeed = 1;

// Some domain of the property gives scenes that the subject takes.
bool HasADomainFor(const Property& property, const SubjectInfo& info) {
  for (const std::string_view name : property.domains) {
    if (Suits(*FindDomain(name), info)) return true;
  }
  return false;
}

TEST(Catalog, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const Property& property : Catalog()) {
    EXPECT_TRUE(names.insert(property.name).second) << property.name;
  }
}

TEST(Catalog, EveryPropertyIsFoundByItsName) {
  for (const Property& property : Catalog()) EXPECT_EQ(FindProperty(property.name), &property);
  EXPECT_EQ(FindProperty("NoSuchProperty"), nullptr);
}

TEST(Catalog, EveryPropertySaysWhatItEnforcesAndBelongsToAGroup) {
  const std::set<std::string_view> groups{"edge",   "incremental", "barycentric", "coverage",
                                          "values", "square",      "wireframe",   "extremes"};
  for (const Property& property : Catalog()) {
    EXPECT_TRUE(groups.contains(property.group)) << property.name;
    EXPECT_FALSE(property.clause.empty()) << property.name;
    EXPECT_FALSE(property.tolerance.empty()) << property.name;
  }
}

TEST(Catalog, EveryDomainThatAPropertyNamesExists) {
  for (const Property& property : Catalog()) {
    EXPECT_FALSE(property.domains.empty()) << property.name;
    for (const std::string_view name : property.domains) {
      EXPECT_NE(FindDomain(name), nullptr) << property.name << ": " << name;
    }
  }
}

// Runs every property that has something to say about the subject.
class SoundSubjects : public ::testing::TestWithParam<std::string_view> {};

TEST_P(SoundSubjects, HoldOnEveryCase) {
  constexpr std::uint64_t kCases = Cases<std::uint64_t>(36);
  const auto subject = subjects::MakeBuiltin(GetParam());
  for (const Property& property : Catalog()) {
    if (!HasADomainFor(property, subject->Info())) continue;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const Case c = DrawCase(subject->Info(), property, kSeed, i);
      const Verdict verdict = RunCase(*subject, property, c);
      ASSERT_NE(verdict.outcome, Outcome::kViolated)
          << property.name << ", " << c.origin << ": " << verdict.message;
      ASSERT_LE(verdict.worst_ratio, 1) << property.name << ", " << c.origin;
      if (verdict.outcome == Outcome::kNotApplicable) break;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Exact, SoundSubjects,
                         ::testing::Values("spans-exact", "filtered-exact", "i64-snap8",
                                           "hom-exact"),
                         [](const auto& info) {
                           std::string name(info.param);
                           std::erase(name, '-');
                           return name;
                         });

// Float methods may miss samples, never their own proven bounds.
TEST(FloatMethods, StayWithinTheirProvenBounds) {
  constexpr std::uint64_t kCases = Cases<std::uint64_t>(24);
  for (const std::string_view name : {"f32-direct", "f32-affine-fma", "f32-incremental",
                                      "f32-kahan:canonical", "f64-incremental", "textbook"}) {
    const auto subject = subjects::MakeBuiltin(name);
    for (const Property& property : Catalog()) {
      const bool by_bounds = property.group == "edge" || property.group == "barycentric" ||
                             property.group == "wireframe" ||
                             property.name.find("Stepping") != std::string_view::npos;
      if (!by_bounds || !HasADomainFor(property, subject->Info())) continue;
      for (std::uint64_t i = 0; i < kCases; ++i) {
        const Case c = DrawCase(subject->Info(), property, kSeed, i);
        const Verdict verdict = RunCase(*subject, property, c);
        ASSERT_NE(verdict.outcome, Outcome::kViolated)
            << name << ", " << property.name << ", " << c.origin << ": " << verdict.message;
      }
    }
  }
}

// How often the cases of a property's domains put it to the test.
struct Exercise {
  int cases = 0;
  int exercised = 0;
  std::map<std::string, int> by_domain;
};
// `cases` of them; up to kMost if a domain puts none to the test.
Exercise ExerciseOf(Subject& subject, const Property& property, int cases) {
  constexpr int kMost = 384;
  Exercise exercise;
  const auto is_never = [](const auto& domain) { return domain.second == 0; };
  for (int i = 0; i < kMost; ++i) {
    if (i >= cases && std::ranges::none_of(exercise.by_domain, is_never)) break;
    const Case c = DrawCase(subject.Info(), property, kSeed, static_cast<std::uint64_t>(i));
    const Verdict verdict = RunCase(subject, property, c);
    ++exercise.cases;
    if (verdict.exercised != 0) ++exercise.exercised;
    exercise.by_domain[c.scene.name] += verdict.exercised != 0 ? 1 : 0;
  }
  return exercise;
}

TEST(Exercise, MostCasesPutTheirPropertyToTheTest) {
  const auto subject = subjects::MakeBuiltin("spans-exact");
  for (const Property& property : Catalog()) {
    if (!HasADomainFor(property, subject->Info())) continue;
    if (RunCase(*subject, property, DrawCase(subject->Info(), property, kSeed, 0)).outcome ==
        Outcome::kNotApplicable) {
      continue;
    }
    if (property.name == "LargeTargetIsCoveredLikeASmallOne") continue;  // two of 1000, on purpose
    const Exercise exercise = ExerciseOf(*subject, property, kOneCaseIn > 1 ? 24 : 96);
    EXPECT_GE(2 * exercise.exercised, exercise.cases) << property.name;
    for (const auto& [domain, exercised] : exercise.by_domain) {
      EXPECT_GT(exercised, 0) << property.name << " is never exercised by " << domain;
    }
  }
}

TEST(Exercise, ClipSpacePropertiesArePutToTheTestByAClipSpaceSubject) {
  const auto subject = subjects::MakeBuiltin("hom-exact");
  for (const std::string_view name :
       {"LiftedTrianglesCoverLikeProjectedOnes", "ScalingClipVerticesKeepsCoverage",
        "ClipSpaceCoverageEqualsTheModel", "ClosedSurfaceAroundTheEyeIsSeenEquallyOften"}) {
    const Exercise exercise = ExerciseOf(*subject, *FindProperty(name), 44);
    EXPECT_GE(2 * exercise.exercised, exercise.cases) << name;
  }
}

// RunCase throws if a property fails over what a subject answers: that is our fault, never its own.
TEST(EveryProperty, ReachesAVerdictOfASubjectThatRefusesAndBreaksDownAndShowsNoNumbers) {
  const auto misbehave = [n = std::make_shared<int>(0)] {
    switch (++*n % 12) {
      case 2:
        throw SubjectStop(Stop::kRefused, "it refuses this scene");
      case 5:
        BreakDown("it crashed");
      case 7:
        throw SubjectStop(Stop::kHung, "it gave no answer");
      case 9:
        throw SubjectStop(Stop::kTooSlow, "it took longer than it may");
      case 11:
        throw std::runtime_error("something went wrong");
      default:
        return;
    }
  };
  const auto method = subjects::MakeBuiltin("f32-direct");
  FakeSubject draws(method->Info(),
                    [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                      misbehave();
                      DrawOnto(*method, scene, options, counts);
                    });
  draws.edges = method->Edges();
  draws.barycentrics = method->Barycentrics();
  const auto fragments = subjects::MakeMutant("legal:centroid-direct3d-1x");
  FakeSubject shows = FakeSubject::Showing(fragments->Info(), [&](const DrawJob& job) {
    misbehave();
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    Drawing drawing = DrawOne(*fragments, job);
    for (double& depth : drawing.depths) depth = kNoNumber;
    for (auto& barycentrics : drawing.barycentrics) barycentrics[1] = kNoNumber;
    return drawing;
  });
  shows.info.takes_batches = true;
  std::set<Outcome> outcomes;
  for (FakeSubject* const subject : {&draws, &shows}) {
    for (const Property& property : Catalog()) {
      if (!HasADomainFor(property, subject->Info())) continue;
      for (std::uint64_t i = 0; i < Cases<std::uint64_t>(4); ++i) {
        const Case c = DrawCase(subject->Info(), property, kSeed, i);
        outcomes.insert(RunCase(*subject, property, c).outcome);
      }
    }
  }
  EXPECT_GE(outcomes.size(), 4U);
}

Case TwoTriangles() {
  Case c;
  c.scene.width = 8;
  c.scene.height = 8;
  c.scene.vertices = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  c.scene.triangles = {{0, 2, 1}, {0, 3, 2}};
  c.profile = *PresetProfile("real");
  return c;
}

// Of a subject that draws by `draw` and shows exact edge values and barycentrics.
Verdict Judge(std::string_view property, FakeSubject::DrawFunction draw, const Case& c) {
  const auto sound = subjects::MakeBuiltin("spans-exact");
  FakeSubject subject(sound->Info(), std::move(draw));
  subject.edges = sound->Edges();
  subject.barycentrics = sound->Barycentrics();
  return RunCase(subject, *FindProperty(property), c);
}

// An extra count at column 5, row 2, if the second triangle is drawn.
void DrawOneTooMany(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  DrawRight(scene, options, counts);
  const Triangle second{0, 3, 2};
  if (std::ranges::find(scene.triangles, second) != scene.triangles.end()) {
    ++counts.front[counts.Index(5, 2)];
  }
}

TEST(Witness, NamesTheSampleTheTriangleAndTheCounts) {
  const Verdict verdict = Judge("CoverageEqualsTheModel", DrawOneTooMany, TwoTriangles());
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->x, 5);
  EXPECT_EQ(verdict.witness->y, 2);
  EXPECT_EQ(verdict.witness->triangle, 1);
  EXPECT_EQ(verdict.witness->edge, 1) << "the diagonal is nearest";
  EXPECT_EQ(verdict.witness->observed, WitnessValue{(FacingCounts{2, 0})});
  EXPECT_EQ(verdict.witness->expected.front(), WitnessPart(FacingCounts{1, 0}));
  EXPECT_EQ(verdict.witness->expected.size(), 7U) << "and three edge values";
}

TEST(Witness, OfASharedEdgeIsTheSampleCoveredTwice) {
  const auto inclusive = [](const Scene& scene, const DrawOptions&, CoverageCounts& counts) {
    if (scene.triangles.size() == 2) ++counts.front[counts.Index(3, 3)];
    for (std::uint32_t& count : counts.front) ++count;
  };
  const Verdict verdict = Judge("SharedEdgeSamplesAreCoveredOnce", inclusive, TwoTriangles());
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->x, 3);
  EXPECT_EQ(verdict.witness->y, 3);
  EXPECT_EQ(TextOfValue(verdict.witness->observed), "covered 2 times");
  EXPECT_EQ(TextOfValue(verdict.witness->expected), "exactly once");
}

TEST(Witness, OfAnEdgeValueHoldsHexAndTheExactValue) {
  // Wrong for edges whose ends differ in |x|: the first of them is edge 1 of the second triangle.
  Case c = TwoTriangles();
  c.scene.vertices = {{-8, 0}, {8, 0}, {8, 8}, {0, 8}, {-8, 8}};
  c.scene.triangles = {{0, 2, 1}, {3, 1, 4}};
  const auto subject = subjects::MakeMutant("mutant:edge-from-one-end");
  const Verdict verdict = RunCase(*subject, *FindProperty("EdgeErrorStaysWithinItsBound"), c);
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->triangle, 1);
  EXPECT_EQ(verdict.witness->edge, 1);
  EXPECT_EQ(TextOfValue(verdict.witness->observed).substr(0, 2), "0x");
  EXPECT_EQ(TextOfValue(verdict.witness->expected).substr(0, 4), "E = ");
}

// What is legal is never failed.
TEST(Fairness, AContractOfNoneIsNeverJudgedForCoverage) {
  Case c = TwoTriangles();
  c.profile.contract = Contract::kNone;
  for (const Property& property : Catalog()) {
    const bool about_memory = property.name == "DrawStaysInsideItsTarget";
    if (property.group != "coverage" && property.group != "extremes") continue;
    if (about_memory) continue;
    EXPECT_EQ(Judge(property.name, DrawOneTooMany, c).outcome, Outcome::kNotApplicable)
        << property.name;
  }
}

TEST(Fairness, AWatertightSubjectIsJudgedOnMeshesOnlyAndAwayFromTheirOutline) {
  Case c = TwoTriangles();
  c.scene.width = 16;
  c.profile.contract = Contract::kWatertight;
  // One sample too many beside the outline, another beside the diagonal.
  const auto extra = [](int x, int y) {
    return [x, y](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
      DrawRight(scene, options, counts);
      ++counts.front[counts.Index(x, y)];
    };
  };
  EXPECT_EQ(Judge("CoverageEqualsTheModel", extra(8, 4), c).outcome, Outcome::kNotApplicable);
  EXPECT_EQ(Judge("EmbeddedMeshSamplesAreCoveredOnce", extra(8, 4), c).outcome, Outcome::kHolds);
  EXPECT_EQ(Judge("EmbeddedMeshSamplesAreCoveredOnce", extra(4, 4), c).outcome, Outcome::kViolated);
  EXPECT_EQ(Judge("EmbeddedMeshSamplesAreCoveredOnce", extra(11, 4), c).outcome,
            Outcome::kViolated);
  EXPECT_EQ(Judge("SharedEdgeSamplesAreCoveredOnce", extra(4, 4), c).outcome, Outcome::kViolated);
}

// A bug that a contract does not speak of leaves every property about coverage alone but its own.
TEST(Fairness, WeakContractsAreHeldToTheirOwnPropertyOnly) {
  Case c = TwoTriangles();
  const auto judged = [&](Contract contract, std::string_view property) {
    c.profile.contract = contract;
    return Judge(property, DrawOneTooMany, c).outcome;
  };
  for (const Contract contract :
       {Contract::kClosed, Contract::kAtLeastModel, Contract::kAtMostModel}) {
    for (const std::string_view property :
         {"CoverageEqualsTheModel", "EmbeddedMeshSamplesAreCoveredOnce",
          "SharedEdgeSamplesAreCoveredOnce", "SignedCoverageEqualsTheWindingNumber",
          "TriangleOrderKeepsCoverage", "OneLegalModelExplainsTheMesh"}) {
      EXPECT_EQ(judged(contract, property), Outcome::kNotApplicable) << property;
    }
    EXPECT_EQ(judged(contract, "EqualDrawsGiveEqualCounts"), Outcome::kHolds);
  }
  const std::string_view conservative = "CoverageKeepsToItsSideOfTheModel";
  EXPECT_EQ(judged(Contract::kAtLeastModel, conservative), Outcome::kHolds);
  EXPECT_EQ(judged(Contract::kAtMostModel, conservative), Outcome::kViolated);
  EXPECT_EQ(judged(Contract::kClosed, conservative), Outcome::kNotApplicable);
  EXPECT_EQ(judged(Contract::kSampleExact, conservative), Outcome::kNotApplicable);
  // Both sides of the sheet: a closed surface. The extra count has no counterpart behind.
  c.scene.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(judged(Contract::kClosed, "ClosedMeshCancels"), Outcome::kViolated);
  EXPECT_EQ(Judge("ClosedMeshCancels", DrawRight, c).outcome, Outcome::kHolds);
}

TEST(Fairness, AFreeProfileIsNotHeldToTheCanonicalModel) {
  Case c = TwoTriangles();
  c.profile.snap.bits = 4;
  c.profile.freedom.snap_tolerance = 0.6;
  for (const std::string_view property :
       {"CoverageEqualsTheModel", "SignedCoverageEqualsTheWindingNumber",
        "VertexRotationKeepsCoverage"}) {
    EXPECT_EQ(Judge(property, DrawOneTooMany, c).outcome, Outcome::kNotApplicable) << property;
  }
  // It is asked what users want, too: AuthorityOf says that it is not stated.
  EXPECT_EQ(AuthorityOf(*FindProperty("IntegerTranslationMovesCoverage"), c.profile).authority,
            Authority::kQuality);
  EXPECT_EQ(Judge("OneLegalModelExplainsTheMesh", DrawOneTooMany, c).outcome, Outcome::kViolated);
  for (const std::string_view property :
       {"TileSizeKeepsCoverage", "TriangleOrderKeepsCoverage", "OneLegalModelExplainsTheMesh"}) {
    EXPECT_EQ(Judge(property, DrawRight, c).outcome, Outcome::kHolds) << property;
  }
}

TEST(Fairness, BeyondTheCoordinateLimitOnlyTheDrawItselfIsJudged) {
  Case c = TwoTriangles();
  c.profile.coordinate_limit = 4;
  for (const Property& property : Catalog()) {
    const Outcome outcome = Judge(property.name, DrawRight, c).outcome;
    if (property.name == "DrawStaysInsideItsTarget") {
      EXPECT_EQ(outcome, Outcome::kHolds);
    } else {
      EXPECT_NE(outcome, Outcome::kHolds) << property.name;
      EXPECT_NE(outcome, Outcome::kViolated) << property.name;
    }
  }
}

TEST(Fairness, AnInclusiveTieRuleMayCoverSharedEdgesTwice) {
  Case c = TwoTriangles();
  c.profile.tie_rule.inclusive = true;
  const auto inclusive = [](const Scene& scene, const DrawOptions& options,
                            CoverageCounts& counts) {
    Profile profile;
    profile.tie_rule.inclusive = true;
    counts += exact::Coverage(scene, profile, options);
  };
  for (const std::string_view name :
       {"SharedEdgeSamplesAreCoveredOnce", "EmbeddedMeshSamplesAreCoveredOnce"}) {
    EXPECT_EQ(Judge(name, inclusive, c).outcome, Outcome::kHolds) << name;
    EXPECT_EQ(Judge(name, DrawRight, c).outcome, Outcome::kHolds)
        << name << ": once is at least once";
    c.profile.tie_rule.inclusive = false;
    EXPECT_EQ(Judge(name, inclusive, c).outcome, Outcome::kViolated) << name;
    c.profile.tie_rule.inclusive = true;
  }
  for (const std::string_view name :
       {"SignedCoverageEqualsTheWindingNumber", "ClosedMeshCancels"}) {
    EXPECT_EQ(Judge(name, DrawRight, c).outcome, Outcome::kNotApplicable) << name;
  }
  c.profile.tie_rule = {.exclusive = true};
  EXPECT_EQ(Judge("SharedEdgeSamplesAreCoveredOnce", DrawRight, c).outcome,
            Outcome::kNotApplicable);
}

TEST(Fairness, ABoundThatIsNotStatedIsNotJudged) {
  // Products overflow in float32: the reference states no bound, and any value will do.
  Case c = TwoTriangles();
  c.scene.vertices = {{0x1p100, 0x1p101}, {-0x1p100, 0x1.8p101}, {0x1p102, -0x1p100}};
  c.scene.triangles = {{0, 1, 2}};
  const auto subject = subjects::MakeBuiltin("f32-direct");
  EXPECT_EQ(RunCase(*subject, *FindProperty("EdgeErrorStaysWithinItsBound"), c).outcome,
            Outcome::kNotExercised);
}

TEST(Fairness, AT_JunctionIsExpectedToCrackAsTheOracleSays) {
  // The middle vertex of the long side, rounded off it, opens a real gap: the winding number knows.
  Case c = TwoTriangles();
  c.scene.vertices = {{0, 0}, {8, 3}, {4, 1.25}, {0, 8}, {8, 0}};
  c.scene.triangles = {{0, 3, 1}, {0, 2, 4}, {2, 1, 4}};
  const auto subject = subjects::MakeBuiltin("spans-exact");
  EXPECT_EQ(RunCase(*subject, *FindProperty("SignedCoverageEqualsTheWindingNumber"), c).outcome,
            Outcome::kHolds);
}

}  // namespace
}  // namespace rasterproof::props
