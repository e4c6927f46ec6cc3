// A survey counts what was planted, keeps its first case, and counts nothing of a right rasterizer.
#include "props/compare/survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/call_end.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

DomainSurvey SurveyOf(Subject& subject, std::string_view domain, std::uint64_t cases = 60) {
  SurveyPlan plan;
  plan.model = subject.Info().profile;
  plan.cases = cases;
  return SurveyDomain(subject, domain, plan);
}

const FaultyCase& FindingOf(const DomainSurvey& survey, Fault fault) {
  const auto found = std::ranges::find(survey.findings, fault, &FaultyCase::fault);
  if (found == survey.findings.end()) throw std::runtime_error("it was not found");
  return *found;
}

// The exact model, but for what `change` makes of the scene before it is drawn.
template <class Change>
FakeSubject Draws(const SubjectInfo& info, Change change) {
  return {info,
          [info, change](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            Scene changed = scene;
            change(changed);
            counts += exact::Coverage(changed, info.profile, options);
          }};
}

TEST(Survey, DrawsFromDomainsThatThereAre) {
  for (const SurveyedDomain& surveyed : SurveyedDomains()) {
    EXPECT_NE(FindDomain(surveyed.name), nullptr) << surveyed.name;
  }
}

TEST(Survey, CountsNothingOfARightRasterizer) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8), SnappedInfo(0)}) {
    FakeSubject subject = testing::Sound(info);
    for (const SurveyedDomain& surveyed : SurveyedDomains()) {
      const DomainSurvey survey = SurveyOf(subject, surveyed.name);
      EXPECT_EQ(survey.cases, 60U) << surveyed.name;
      EXPECT_EQ(survey.wrong + survey.gaps + survey.overlaps, 0U) << surveyed.name;
      EXPECT_TRUE(survey.findings.empty()) << surveyed.name;
      EXPECT_GT(survey.samples, survey.cases) << surveyed.name;
    }
  }
}

TEST(Survey, TakesEveryCaseOfTheseDomainsForACoveringMesh) {
  FakeSubject subject = testing::Sound(SnappedInfo(4));
  for (const std::string_view domain : {"triangulations", "subdivisions", "covering-fans"}) {
    EXPECT_EQ(SurveyOf(subject, domain).meshes, 60U) << domain;
  }
  EXPECT_EQ(SurveyOf(subject, "uniform-subpixel").meshes, 0U);
}

TEST(Survey, CountsAPlantedGapAndKeepsItsCase) {
  FakeSubject subject = testing::WithProfile(
      RealInfo(), [](Profile& profile) { profile.tie_rule = {.exclusive = true}; });
  const DomainSurvey survey = SurveyOf(subject, "triangulations");
  EXPECT_GT(survey.gaps, 0U);
  EXPECT_EQ(survey.overlaps, 0U);
  const FaultyCase& gap = FindingOf(survey, Fault::kGap);
  EXPECT_EQ(ParseCaseName(gap.name).domain, "triangulations");
  EXPECT_EQ(gap.minimal.origin, gap.name);
  EXPECT_LE(gap.minimal.scene.triangles.size(), 4U);
  CoverageCounts counts(gap.minimal.scene.width, gap.minimal.scene.height);
  DrawOnto(subject, gap.minimal.scene, gap.minimal.options, counts);
  EXPECT_GT(Compare(counts, exact::Coverage(gap.minimal.scene, gap.minimal.profile)).missing, 0U);
}

TEST(Survey, NamesTheFirstCaseSoThatItIsDrawnAgain) {
  FakeSubject subject = testing::Inclusive(RealInfo());
  SurveyPlan plan;
  plan.model = subject.Info().profile;
  plan.cases = 60;
  plan.shrink_budget = 0;
  const DomainSurvey survey = SurveyDomain(subject, "fans", plan);
  EXPECT_GT(survey.overlaps, 0U);
  EXPECT_EQ(survey.gaps, 0U);
  const FaultyCase& overlap = FindingOf(survey, Fault::kOverlap);
  EXPECT_EQ(overlap.minimal, DrawCase(subject.Info(), ParseCaseName(overlap.name)));
}

TEST(Survey, CountsGapsAndOverlapsWhateverTieRuleTheModelHas) {
  FakeSubject subject = testing::Inclusive(RealInfo());
  SurveyPlan plan;
  plan.model = subject.Info().profile;
  plan.model.tie_rule = {.inclusive = true};
  plan.cases = 60;
  const DomainSurvey survey = SurveyDomain(subject, "triangulations", plan);
  EXPECT_EQ(survey.wrong, 0U);
  EXPECT_EQ(survey.meshes, 60U);
  EXPECT_GT(survey.overlaps, 0U);
}

TEST(Survey, CountsWrongSamplesOfSingleTriangles) {
  FakeSubject subject = testing::DropsLastColumn(RealInfo());
  const DomainSurvey survey = SurveyOf(subject, "uniform-subpixel");
  EXPECT_GT(survey.wrong, 0U);
  EXPECT_EQ(FindingOf(survey, Fault::kWrong).minimal.scene.triangles.size(), 1U);
}

TEST(Survey, FindsACallThatIsNotTheSumOfItsTriangles) {
  FakeSubject subject = Draws(RealInfo(), [](Scene& scene) {
    if (scene.triangles.size() > 1) scene.triangles.pop_back();
  });
  const DomainSurvey survey = SurveyOf(subject, "axis-aligned");
  EXPECT_GT(survey.Faulty(Fault::kBatch), 0U);
  EXPECT_EQ(FindingOf(survey, Fault::kBatch).minimal.scene.triangles.size(), 2U);
}

TEST(Survey, FindsOverlapsOfASubjectThatShowsNoCounts) {
  SubjectInfo info = RealInfo();
  info.coverage = CoverageKind::kMask;
  FakeSubject subject(info,
                      [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                        Profile inclusive;
                        inclusive.tie_rule = {.inclusive = true};
                        const CoverageCounts drawn = exact::Coverage(scene, inclusive, options);
                        for (std::size_t k = 0; k < drawn.size(); ++k)
                          counts.front[k] = std::min(drawn.Count(k), 1U);
                      });
  const DomainSurvey survey = SurveyOf(subject, "fans");
  EXPECT_GT(survey.overlaps, 0U);
  EXPECT_EQ(survey.Faulty(Fault::kBatch), 0U);
}

TEST(Survey, KeepsTheCaseOfACrashAndGivesTheDomainUpAtTheFourth) {
  FakeSubject subject = testing::Throwing(RealInfo());
  const DomainSurvey survey = SurveyOf(subject, "covering-fans");
  EXPECT_EQ(survey.Faulty(Fault::kEnd), 4U);
  const FaultyCase& crash = FindingOf(survey, Fault::kEnd);
  EXPECT_FALSE(crash.end.empty());
  EXPECT_EQ(crash.minimal.scene.triangles.size(), 1U);
}

TEST(Survey, CountsRefusalsApart) {
  FakeSubject subject(RealInfo(), [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw SubjectStop(Stop::kRefused, "it is not drawn");
  });
  const DomainSurvey survey = SurveyOf(subject, "fans");
  EXPECT_EQ(survey.refused, 60U);
  EXPECT_EQ(survey.cases, 0U);
  EXPECT_TRUE(survey.findings.empty());
}

TEST(Survey, DoesNotCompareWhatTheProfileSaysNothingOf) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.guard_band = WindowBox{-64, -64, 64, 64};
  FakeSubject subject = testing::Sound(info);
  const DomainSurvey survey = SurveyOf(subject, "covering-fans");
  EXPECT_GT(survey.unjudged, 0U);
  EXPECT_EQ(survey.cases + survey.unjudged, 60U);
}

TEST(Survey, DrawsNothingOfADomainThatTheSubjectCannotBeGiven) {
  FakeSubject subject = testing::Sound(RealInfo());
  EXPECT_EQ(SurveyOf(subject, "perspective").cases, 0U);
}

}  // namespace
}  // namespace rasterproof::props
