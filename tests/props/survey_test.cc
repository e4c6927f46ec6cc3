// A survey counts what was planted, keeps the worst case, and counts nothing of a right rasterizer.
#include "props/compare/survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

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

// In the order of kSurveyYardsticks.
enum Column : std::size_t { kModel, kGaps, kOverlaps, kBatch };

std::vector<Cell> SurveyOf(Subject& subject, std::string_view domain, std::uint64_t cases = 60) {
  SurveyPlan plan;
  plan.model = subject.Info().profile;
  plan.cases = cases;
  return SurveyDomain(subject, domain, plan);
}

std::uint64_t WrongSamplesOf(const std::vector<Cell>& cells) {
  std::uint64_t wrong = 0;
  for (const Cell& cell : cells) wrong += cell.wrong_samples;
  return wrong;
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
      const std::vector<Cell> survey = SurveyOf(subject, surveyed.name);
      EXPECT_EQ(survey[kModel].cases, 60U) << surveyed.name;
      EXPECT_EQ(WrongSamplesOf(survey), 0U) << surveyed.name;
      EXPECT_GT(survey[kModel].samples, survey[kModel].cases) << surveyed.name;
    }
  }
}

TEST(Survey, TakesEveryCaseOfTheseDomainsForACoveringMesh) {
  FakeSubject subject = testing::Sound(SnappedInfo(4));
  for (const std::string_view domain : {"triangulations", "subdivisions", "covering-fans"}) {
    EXPECT_EQ(SurveyOf(subject, domain)[kGaps].cases, 60U) << domain;
  }
  EXPECT_EQ(SurveyOf(subject, "uniform-subpixel")[kGaps].cases, 0U);
}

TEST(Survey, CountsAPlantedGapAndKeepsItsCase) {
  FakeSubject subject = testing::WithProfile(
      RealInfo(), [](Profile& profile) { profile.tie_rule = {.exclusive = true}; });
  const std::vector<Cell> survey = SurveyOf(subject, "triangulations");
  EXPECT_GT(survey[kGaps].wrong_samples, 0U);
  EXPECT_EQ(survey[kOverlaps].wrong_samples, 0U);
  const Case& gap = *survey[kGaps].Worst();
  EXPECT_EQ(ParseCaseName(gap.origin).domain, "triangulations");
  CoverageCounts counts(gap.scene.width, gap.scene.height);
  DrawOnto(subject, gap.scene, gap.options, counts);
  EXPECT_GT(Compare(counts, exact::Coverage(gap.scene, Profile{})).missing, 0U);
}

TEST(Survey, NamesTheWorstCaseSoThatItIsDrawnAgain) {
  FakeSubject subject = testing::Inclusive(RealInfo());
  const std::vector<Cell> survey = SurveyOf(subject, "fans");
  EXPECT_GT(survey[kOverlaps].wrong_samples, 0U);
  EXPECT_EQ(survey[kGaps].wrong_samples, 0U);
  const Case& overlap = *survey[kOverlaps].Worst();
  EXPECT_EQ(overlap, DrawCase(subject.Info(), ParseCaseName(overlap.origin)));
}

TEST(Survey, CountsGapsAndOverlapsWhateverTieRuleTheModelHas) {
  FakeSubject subject = testing::Inclusive(RealInfo());
  SurveyPlan plan;
  plan.model = subject.Info().profile;
  plan.model.tie_rule = {.inclusive = true};
  plan.cases = 60;
  const std::vector<Cell> survey = SurveyDomain(subject, "triangulations", plan);
  EXPECT_EQ(survey[kModel].wrong, 0U);
  EXPECT_EQ(survey[kGaps].cases, 60U);
  EXPECT_GT(survey[kOverlaps].wrong_samples, 0U);
}

TEST(Survey, MeasuresHowFarWrongSamplesLieFromAnEdge) {
  FakeSubject subject = testing::DropsLastColumn(RealInfo());
  const std::vector<Cell> survey = SurveyOf(subject, "uniform-subpixel");
  EXPECT_GT(survey[kModel].wrong_samples, 0U);
  EXPECT_GT(survey[kModel].furthest, 0);
}

TEST(Survey, FindsACallThatIsNotTheSumOfItsTriangles) {
  FakeSubject subject = Draws(RealInfo(), [](Scene& scene) {
    if (scene.triangles.size() > 1) scene.triangles.pop_back();
  });
  EXPECT_GT(SurveyOf(subject, "axis-aligned")[kBatch].wrong, 0U);
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
  const std::vector<Cell> survey = SurveyOf(subject, "fans");
  EXPECT_GT(survey[kOverlaps].wrong_samples, 0U);
  EXPECT_EQ(survey[kBatch].wrong, 0U);
}

TEST(Survey, KeepsTheCaseOfACrashAndGivesTheDomainUpAtTheFourth) {
  FakeSubject subject = testing::Throwing(RealInfo());
  const Cell crashes = SurveyOf(subject, "covering-fans")[kModel];
  EXPECT_EQ(crashes.ended, 4U);
  EXPECT_FALSE(crashes.why.empty());
  EXPECT_EQ(ParseCaseName(crashes.Worst()->origin).index, 0U);
}

TEST(Survey, CountsRefusalsApart) {
  FakeSubject subject(RealInfo(), [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw SubjectStop(Stop::kRefused, "it is not drawn");
  });
  const Cell refused = SurveyOf(subject, "fans")[kModel];
  EXPECT_EQ(refused.refused, 60U);
  EXPECT_EQ(refused.cases, 0U);
}

TEST(Survey, DoesNotCompareWhatTheProfileSaysNothingOf) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.guard_band = WindowBox{-64, -64, 64, 64};
  FakeSubject subject = testing::Sound(info);
  const Cell survey = SurveyOf(subject, "covering-fans")[kModel];
  EXPECT_GT(survey.excused, 0U);
  EXPECT_EQ(survey.cases + survey.excused, 60U);
}

TEST(Survey, DrawsNothingOfADomainThatTheSubjectCannotBeGiven) {
  FakeSubject subject = testing::Sound(RealInfo());
  EXPECT_EQ(SurveyOf(subject, "perspective")[kModel].cases, 0U);
}

}  // namespace
}  // namespace rasterproof::props
