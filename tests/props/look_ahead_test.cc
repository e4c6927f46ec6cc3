// Draws in batches give the verdicts of draws one by one.
#include "props/run/look_ahead.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/domains/domain.h"
#include "props/run/campaign.h"
#include "tests/props/planted_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kLookAheadSeed = 1;

// The exact model of a profile, and how it was called.
class Called final : public Subject {
 public:
  explicit Called(SubjectInfo info, Profile drawn) : info_(std::move(info)), drawn_(drawn) {}
  const SubjectInfo& OwnInfo() const override { return info_; }
  bool SharesCalls() const override { return true; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    ++draws;
    if (keeps_scenes) drawn.push_back(scene);
    if (breaks_left_of < 0) {
      for (const Vertex& v : scene.vertices) {
        if (v.x < breaks_left_of) BreakDown("it broke");
      }
    }
    CoverageCounts covered = exact::Coverage(scene, drawn_, options);
    if (info_.coverage != CoverageKind::kFacingCounts) {
      for (std::size_t k = 0; k < covered.size(); ++k) {
        covered.front[k] += std::exchange(covered.back[k], 0);
        if (info_.coverage == CoverageKind::kMask && covered.front[k] > 1) covered.front[k] = 1;
      }
    }
    counts += covered;
  }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    calls.push_back(jobs.size());
    if (keeps_scenes && jobs.size() > 1) {
      scenes.emplace_back();
      for (const DrawJob& job : jobs) scenes.back().push_back(SceneOf(job));
    }
    std::vector<DrawOutcome> outcomes = Subject::DrawMany(jobs);
    if (leaks && outcomes.size() > 8) ++outcomes[8].drawing.counts.front[0];
    return outcomes;
  }

  std::size_t draws = 0;
  std::vector<std::size_t> calls;  ///< how many jobs each had
  bool keeps_scenes = false;
  std::vector<std::vector<Scene>> scenes;  ///< of each call for many draws
  std::vector<Scene> drawn;                ///< in the order of drawing
  double breaks_left_of = 0;
  bool leaks = false;

 private:
  SubjectInfo info_;
  Profile drawn_;
};

struct Outside {
  explicit Outside(std::unique_ptr<Called> called_) : called(*called_), whole(std::move(called_)) {}
  Called& called;
  std::unique_ptr<Subject> whole;
};

Outside Make(CoverageKind kind, bool inclusive) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = kind;
  info.takes_batches = true;
  Profile drawn = info.profile;
  drawn.tie_rule.inclusive = inclusive;
  return Outside(std::make_unique<Called>(info, drawn));
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
std::vector<Trial> ExpectTheSameVerdicts(Outside outside, const Property& property,
                                         std::uint64_t n) {
  const std::vector<Case> cases = SomeCases(outside.whole->Info(), property, n);
  const std::vector<Trial> batched = TryTogether(*outside.whole, property, cases);
  EXPECT_FALSE(batched.empty());
  for (std::size_t k = 0; k < batched.size(); ++k) {
    const Verdict alone = RunCase(*outside.whole, property, cases[k]);
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
  for (const Property& property : Catalog()) {
    for (const CoverageKind kind :
         {CoverageKind::kFacingCounts, CoverageKind::kCounts, CoverageKind::kMask}) {
      if (!HasADomain(property, testing::RealInfo())) continue;
      ExpectTheSameVerdicts(Make(kind, false), property, kCases);
      ExpectTheSameVerdicts(Make(kind, true), property, kCases);
    }
  }
}

TEST(Batches, NameTheCaseThatBreaksTheSubjectDown) {
  const Property& property = *FindProperty("CoverageEqualsTheModel");
  Outside outside = Make(CoverageKind::kCounts, false);
  outside.called.breaks_left_of = -100;
  const std::vector<Trial> trials = ExpectTheSameVerdicts(std::move(outside), property, 40);
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials.back().stop, Stop::kBrokeDown);
}

TEST(Batches, PutTheDrawsOfManyCasesIntoOneCall) {
  const Property& property = *FindProperty("CoverageEqualsTheModel");
  const Outside outside = Make(CoverageKind::kFacingCounts, false);
  const std::vector<Case> cases = SomeCases(outside.whole->Info(), property, 20);
  TryTogether(*outside.whole, property, cases);
  EXPECT_EQ(outside.called.calls, (std::vector<std::size_t>{20}));
  EXPECT_EQ(outside.called.draws, 20U);
}

TEST(Batches, AreWhatACampaignDraws) {
  const Outside outside = Make(CoverageKind::kFacingCounts, false);
  CampaignOptions options;
  options.cases = 64;
  const PropertyResult result =
      RunCampaign(*outside.whole, *FindProperty("CoverageEqualsTheModel"), options);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_EQ(outside.called.calls, (std::vector<std::size_t>{32, 32}));
}

TEST(Batches, ThatChangeWhatIsDrawnAreAFinding) {
  const Outside outside = Make(CoverageKind::kFacingCounts, false);
  outside.called.leaks = true;
  CampaignOptions options;
  options.cases = 64;
  const PropertyResult result =
      RunCampaign(*outside.whole, *FindProperty("CoverageEqualsTheModel"), options);
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  const Case ninth =
      DrawCase(outside.whole->Info(), *FindProperty("CoverageEqualsTheModel"), kDefaultSeed, 8);
  EXPECT_EQ(result.failing_case, ninth.origin);
  EXPECT_NE(result.message.find("alone the case does not fail"), std::string::npos)
      << result.message;
}

// Runs 64 cases, which all hold, and keeps their scenes.
void KeepScenes(const Outside& outside, std::string_view property) {
  outside.called.keeps_scenes = true;
  CampaignOptions options;
  options.cases = 64;
  const PropertyResult result = RunCampaign(*outside.whole, *FindProperty(property), options);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_FALSE(outside.called.drawn.empty());
}

TEST(Batches, LeaveCallsThatMustFollowEachOtherAlone) {
  const Outside outside = Make(CoverageKind::kCounts, false);
  KeepScenes(outside, "EqualDrawsGiveEqualCounts");
  const std::vector<Scene>& drawn = outside.called.drawn;
  ASSERT_EQ(drawn.size() % 2, 0U);
  for (std::size_t k = 0; k < drawn.size(); k += 2) EXPECT_TRUE(drawn[k] == drawn[k + 1]) << k;
}

TEST(Batches, AddNothingToACallThatAPropertyPutsTogether) {
  const Outside outside = Make(CoverageKind::kFacingCounts, false);
  KeepScenes(outside, "BatchDrawsLikeSingleCalls");
  EXPECT_EQ(outside.called.scenes.size(), 64U);
  for (const std::vector<Scene>& scenes : outside.called.scenes) {
    EXPECT_LE(scenes.size(), 12U);
    ASSERT_GT(scenes.size(), 4U);
    EXPECT_TRUE(scenes.front() == scenes.back()) << "the case comes first and last";
  }
}

}  // namespace
}  // namespace rasterproof::props
