// The catalogue has every family, passes what is right by a yardstick and fails what is not.
#include "props/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "core/call_end.h"
#include "core/sample_pattern.h"
#include "core/subject_info.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

Family FamilyOf(std::string_view name) {
  const std::vector<Family> families = Catalogue();
  return *std::ranges::find(families, name, &Family::name);
}

FamilyResult Measured(Subject& subject, std::string_view family, std::uint64_t cases = 40) {
  return MeasureFamily(subject, FamilyOf(family), {.cases = cases});
}

std::unique_ptr<Subject> Mutant(const char* name) { return subjects::MakeMutant(name); }

TEST(Catalogue, HasEveryDomainAndEveryWorldOnce) {
  std::multiset<std::string_view> expected;
  for (const Domain& domain : Domains()) expected.insert(domain.name);
  for (const World& world : Worlds()) expected.insert(world.name);
  std::multiset<std::string_view> there;
  for (const Family& family : Catalogue()) there.insert(family.name);
  EXPECT_EQ(there, expected);
}

TEST(Catalogue, ASoundSubjectStandsOnBothYardsticksWhereItsModelIsRealGeometry) {
  FakeSubject subject = testing::Sound(RealInfo());
  for (const char* family : {"needles", "near-edge", "grids", "degenerate", "product-overflow"}) {
    for (const FamilyCell& cell : Measured(subject, family).cells) {
      EXPECT_EQ(cell.wrong, 0U) << family << " " << cell.why;
      EXPECT_EQ(cell.cases + cell.excused, 40U) << family;
      EXPECT_GT(cell.cases, 0U) << family;
    }
  }
}

TEST(Catalogue, ASnapIsRightByItsModelAndDisplacedFromRealGeometry) {
  FakeSubject subject = testing::Sound(SnappedInfo(4));
  const FamilyResult result = Measured(subject, "snap-ties", 200);
  EXPECT_EQ(result.By(Yardstick::kOwnModel).wrong, 0U);
  const FamilyCell& real = result.By(Yardstick::kRealGeometry);
  EXPECT_GT(real.wrong, 0U);
  EXPECT_GT(real.worst_pixels, 0);
  EXPECT_LE(real.worst_pixels, std::hypot(0.5, 0.5) / 16);  // half a step each way
  ASSERT_TRUE(real.worst);
}

TEST(Catalogue, AWrongRuleFailsWhereItIsDecidedAndNowhereElse) {
  const std::unique_ptr<Subject> subject = Mutant("mutant:ties-inclusive");
  EXPECT_TRUE(Measured(*subject, "vertices-on-samples").By(Yardstick::kOwnModel).Fails());
  EXPECT_FALSE(Measured(*subject, "needles").By(Yardstick::kOwnModel).Fails());
}

TEST(Catalogue, TheWorstCaseFailsAgain) {
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin("f32-direct");
  const FamilyCell own = Measured(*subject, "needles").By(Yardstick::kOwnModel);
  ASSERT_TRUE(own.worst);
  CoverageCounts drawn(own.worst->scene.width, own.worst->scene.height);
  DrawOnto(*subject, own.worst->scene, own.worst->options, drawn);
  EXPECT_NE(drawn, exact::Coverage(own.worst->scene, own.worst->profile, own.worst->options));
}

TEST(Catalogue, WhatASetLeavesOpenIsNotHeldAgainstASubject) {
  for (const char* name : {"legal:vulkan-4-bits-floor", "legal:vulkan-owner-by-sample",
                           "legal:vulkan-farthest-mask", "legal:vulkan-facing-exchanged"}) {
    const std::unique_ptr<Subject> subject = Mutant(name);
    ASSERT_NE(subject, nullptr) << name;
    for (const char* family : {"snap-ties", "shared-edge", "vertices-on-samples"}) {
      const FamilyCell own = Measured(*subject, family).By(Yardstick::kOwnModel);
      EXPECT_FALSE(own.Fails()) << name << " " << family << " " << own.why;
    }
  }
}

TEST(Catalogue, ASubjectThatEndsFailsAndIsGivenUpAfterFour) {
  std::uint64_t calls = 0;
  FakeSubject subject(RealInfo(), [&](const Scene&, const DrawOptions&, CoverageCounts&) {
    ++calls;
    throw SubjectStop(Stop::kBrokeDown, "killed by signal 11");
  });
  const FamilyResult result = Measured(subject, "grids");
  EXPECT_EQ(calls, 4U);
  for (const FamilyCell& cell : result.cells) {
    EXPECT_EQ(cell.wrong, 4U);
    EXPECT_TRUE(std::isinf(cell.worst_pixels));
    EXPECT_EQ(cell.why, "killed by signal 11");
  }
}

TEST(Catalogue, ASubjectOfWindowSpaceIsExcusedFromClipSpaceWithTheReason) {
  FakeSubject subject = testing::Sound(RealInfo());
  const FamilyCell own = Measured(subject, "mixed-w").By(Yardstick::kOwnModel);
  EXPECT_EQ(own.cases, 0U);
  EXPECT_FALSE(own.why.empty());
}

// Of 100 cases of this family a seed may draw one whose vertices are all finite.
TEST(Catalogue, AFamilyOfWhatTheProfileDoesNotStateIsExcusedForThatAndElseDrawn) {
  FakeSubject one = testing::Sound(SnappedInfo(8));
  const FamilyCell excused = Measured(one, "pattern-lines").By(Yardstick::kOwnModel);
  EXPECT_EQ(excused.cases, 0U);
  EXPECT_EQ(excused.why, "the profile states nothing that the family is about");
  SubjectInfo info = SnappedInfo(8);
  info.profile.pattern = *StandardPattern(4);
  FakeSubject four = testing::Sound(info);
  const FamilyCell drawn = Measured(four, "pattern-lines").By(Yardstick::kOwnModel);
  EXPECT_EQ(drawn.cases, 40U) << drawn.why;
  EXPECT_EQ(drawn.wrong, 0U);
  FakeSubject inclusive = testing::Inclusive(info);
  EXPECT_TRUE(Measured(inclusive, "pattern-lines").By(Yardstick::kOwnModel).Fails());
}

TEST(Catalogue, AFamilyOfWhichHardlyAnyCaseIsJudgedIsExcusedUnlessThatFails) {
  FakeSubject sound = testing::Sound(SnappedInfo(8));
  FakeSubject wrong(SnappedInfo(8), [](const Scene&, const DrawOptions&, CoverageCounts& counts) {
    for (std::uint32_t& count : counts.front) count += 3;
  });
  const Family family = FamilyOf("non-finite");
  std::uint64_t fails = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const CataloguePlan plan{.seed = seed, .cases = 100};
    const FamilyCell cell = MeasureFamily(sound, family, plan).By(Yardstick::kOwnModel);
    EXPECT_EQ(cell.cases, 0U) << seed;
    EXPECT_EQ(cell.excused, 100U) << seed;
    fails += MeasureFamily(wrong, family, plan).By(Yardstick::kOwnModel).wrong;
  }
  EXPECT_GT(fails, 0U);
}

TEST(Catalogue, AWorldIsExhaustedOrExcused) {
  FakeSubject subject = testing::Sound(RealInfo());
  EXPECT_EQ(Measured(subject, "pairs-3x3").By(Yardstick::kOwnModel).cases, 0U);
  const FamilyResult whole = MeasureFamily(subject, FamilyOf("pairs-3x3"), {.cases = 66});
  EXPECT_TRUE(whole.By(Yardstick::kOwnModel).is_exhausted);
  EXPECT_EQ(whole.By(Yardstick::kOwnModel).cases, 6561U);
}

}  // namespace
}  // namespace rasterproof::props
