// Draws in batches give the verdicts of draws one by one.
#include "props/run/look_ahead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/call_end.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/domains/domain.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kLookAheadSeed = 1;

// The exact model, or one whose edges all own their samples, shown as `kind`. Breaks down over a
// vertex left of `least_x`.
FakeSubject Make(CoverageKind kind, bool inclusive, double least_x = -HUGE_VAL) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = kind;
  info.takes_batches = true;
  Profile drawn = info.profile;
  drawn.tie_rule.inclusive = inclusive;
  return FakeSubject::Outside(
      info, [=](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        for (const Vertex& v : scene.vertices) {
          if (v.x < least_x) BreakDown("it broke");
        }
        CoverageCounts covered = exact::Coverage(scene, drawn, options);
        HideFacings(kind, covered);
        counts += covered;
      });
}

std::vector<Case> SomeCases(const SubjectInfo& info, const Property& property, std::uint64_t n) {
  std::vector<Case> cases;
  for (std::uint64_t i = 0; i < n; ++i)
    cases.push_back(DrawCase(info, property, kLookAheadSeed, i));
  return cases;
}

bool HasADomain(const Property& property, const SubjectInfo& info) {
  for (const std::string_view name : property.domains) {
    if (Suits(*FindDomain(name), info)) return true;
  }
  return false;
}

// Runs the cases both ways, up to the first violated one. Returns what came of them together.
std::vector<Trial> ExpectTheSameVerdicts(FakeSubject outside, const Property& property,
                                         std::uint64_t n) {
  const std::vector<Case> cases = SomeCases(outside.Info(), property, n);
  const std::vector<Trial> batched = TryTogether(outside, property, cases);
  EXPECT_FALSE(batched.empty());
  for (std::size_t k = 0; k < batched.size(); ++k) {
    const Verdict alone = RunCase(outside, property, cases[k]);
    const Verdict& together = batched[k].verdict;
    EXPECT_EQ(together.outcome, alone.outcome) << property.name << " " << k;
    EXPECT_EQ(together.message, alone.message) << property.name << " " << k;
    EXPECT_EQ(together.exercised, alone.exercised) << property.name << " " << k;
    const bool is_last = k + 1 == batched.size();
    EXPECT_EQ(is_last, k + 1 == cases.size() || alone.outcome == Outcome::kViolated);
  }
  return batched;
}

TEST(Batches, GiveTheVerdictsOfSingleDraws) {
  constexpr std::uint64_t kCases = Cases<std::uint64_t>(20);
  // Sanitized, one of the kinds for most properties: four has no divisor in common with three.
  constexpr std::size_t kEvery = kOneCaseIn > 1 ? 4 : 1;
  std::size_t number = 0;
  for (const Property& property : Catalog()) {
    for (const CoverageKind kind :
         {CoverageKind::kFacingCounts, CoverageKind::kCounts, CoverageKind::kMask}) {
      if (!HasADomain(property, testing::RealInfo()) || number++ % kEvery != 0) continue;
      ExpectTheSameVerdicts(Make(kind, false), property, kCases);
      ExpectTheSameVerdicts(Make(kind, true), property, kCases);
    }
  }
}

TEST(Batches, NameTheCaseThatBreaksTheSubjectDown) {
  const Property& property = *FindProperty("CoverageEqualsTheModel");
  const std::vector<Trial> trials =
      ExpectTheSameVerdicts(Make(CoverageKind::kCounts, false, -100), property, 40);
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials.back().stop, Stop::kBrokeDown);
}

TEST(Batches, PutTheDrawsOfManyCasesIntoOneCall) {
  const Property& property = *FindProperty("CoverageEqualsTheModel");
  FakeSubject outside = Make(CoverageKind::kFacingCounts, false);
  const std::vector<Case> cases = SomeCases(outside.Info(), property, 20);
  TryTogether(outside, property, cases);
  EXPECT_EQ(outside.calls, (std::vector<std::size_t>{20}));
  EXPECT_EQ(outside.draws, 20U);
}

TEST(Batches, AreWhatACampaignDraws) {
  FakeSubject outside = Make(CoverageKind::kFacingCounts, false);
  CampaignOptions options;
  options.cases = 64;
  const PropertyResult result =
      RunCampaign(outside, *FindProperty("CoverageEqualsTheModel"), options);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  // Some domain's case may ask nothing.
  ASSERT_EQ(outside.calls.size(), 2U);
  EXPECT_EQ(outside.calls[0], 32U);
  EXPECT_GE(outside.calls[1], 24U);
}

TEST(Batches, ThatChangeWhatIsDrawnAreAFinding) {
  FakeSubject outside = Make(CoverageKind::kFacingCounts, false);
  outside.on_answer = [](std::vector<DrawOutcome>& outcomes) {
    if (outcomes.size() > 8) ++outcomes[8].drawing.counts.front[0];
  };
  CampaignOptions options;
  options.cases = 64;
  const PropertyResult result =
      RunCampaign(outside, *FindProperty("CoverageEqualsTheModel"), options);
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  const Case ninth =
      DrawCase(outside.Info(), *FindProperty("CoverageEqualsTheModel"), kDefaultSeed, 8);
  EXPECT_EQ(result.counterexample->failing_case, ninth.origin);
  EXPECT_NE(result.message.find("alone the case does not fail"), std::string::npos)
      << result.message;
}

// Runs 64 cases, which all hold. Returns the scenes of each call.
std::vector<std::vector<Scene>> CallsOf(CoverageKind kind, std::string_view property) {
  std::vector<std::vector<Scene>> calls;
  FakeSubject outside = Make(kind, false);
  outside.on_call = [&](std::span<const DrawJob> jobs) {
    std::vector<Scene>& scenes = calls.emplace_back();
    for (const DrawJob& job : jobs) scenes.push_back(SceneOf(job));
  };
  const PropertyResult result = RunCampaign(outside, *FindProperty(property), {.cases = 64});
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  return calls;
}

TEST(Batches, LeaveCallsThatMustFollowEachOtherAlone) {
  std::vector<Scene> drawn;
  for (const std::vector<Scene>& call :
       CallsOf(CoverageKind::kCounts, "EqualDrawsGiveEqualCounts")) {
    drawn.insert(drawn.end(), call.begin(), call.end());
  }
  ASSERT_FALSE(drawn.empty());
  ASSERT_EQ(drawn.size() % 2, 0U);
  for (std::size_t k = 0; k < drawn.size(); k += 2) EXPECT_TRUE(drawn[k] == drawn[k + 1]) << k;
}

TEST(Batches, AddNothingToACallThatAPropertyPutsTogether) {
  std::size_t batches = 0;
  for (const std::vector<Scene>& scenes :
       CallsOf(CoverageKind::kFacingCounts, "BatchDrawsLikeSingleCalls")) {
    if (scenes.size() == 1) continue;
    ++batches;
    EXPECT_LE(scenes.size(), 12U);
    ASSERT_GT(scenes.size(), 4U);
    EXPECT_TRUE(scenes.front() == scenes.back()) << "the case comes first and last";
  }
  EXPECT_EQ(batches, 64U);
}

}  // namespace
}  // namespace rasterproof::props
