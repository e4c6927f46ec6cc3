// The catalogue has every family, passes what is right by a yardstick and fails what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/sample_pattern.h"
#include "core/subject_info.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "props/compare/compare.h"
#include "props/compare/families.h"
#include "props/compare/yardsticks.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/run/description.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

Family FamilyOf(std::string_view name) {
  const std::vector<Family> families = Families();
  return *std::ranges::find(families, name, &Family::name);
}

// By own model, then by real geometry.
std::vector<Cell> Cells(Subject& subject, std::string_view family, std::uint64_t cases = 40,
                        std::uint64_t seed = 1) {
  const Description description = DescriptionOf(subject);
  const std::vector<Yardstick> yardsticks{OwnModel(description), RealGeometry(description)};
  FamilyPlan plan;
  plan.seed = seed;
  plan.cases = cases;
  return CompareFamily(subject, FamilyOf(family), yardsticks, plan);
}

Cell Own(Subject& subject, std::string_view family, std::uint64_t cases = 40) {
  return Cells(subject, family, cases).front();
}

std::unique_ptr<Subject> Mutant(const char* name) { return subjects::MakeMutant(name); }

TEST(Catalogue, HasEveryDomainAndEveryWorldOnce) {
  std::multiset<std::string_view> expected;
  for (const Domain& domain : Domains()) expected.insert(domain.name);
  for (const World& world : Worlds()) expected.insert(world.name);
  std::multiset<std::string_view> there;
  for (const Family& family : Families()) there.insert(family.name);
  EXPECT_EQ(there, expected);
}

TEST(Catalogue, ASoundSubjectStandsOnBothYardsticksWhereItsModelIsRealGeometry) {
  FakeSubject subject = testing::Sound(RealInfo());
  for (const char* family : {"needles", "near-edge", "grids", "degenerate", "product-overflow"}) {
    for (const Cell& cell : Cells(subject, family)) {
      EXPECT_EQ(cell.wrong, 0U) << family << " " << cell.why;
      EXPECT_EQ(cell.cases + cell.excused, 40U) << family;
      EXPECT_GT(cell.cases, 0U) << family;
    }
  }
}

TEST(Catalogue, ASnapIsRightByItsModelAndDisplacedFromRealGeometry) {
  FakeSubject subject = testing::Sound(SnappedInfo(4));
  const std::vector<Cell> cells = Cells(subject, "snap-ties", 200);
  EXPECT_EQ(cells[0].wrong, 0U);
  const Cell& real = cells[1];
  EXPECT_GT(real.wrong, 0U);
  EXPECT_GT(real.WorstPixels(), 0);
  EXPECT_LE(real.WorstPixels(), std::hypot(0.5, 0.5) / 16);  // half a step each way
  ASSERT_TRUE(real.worst);
}

TEST(Catalogue, AWrongRuleFailsWhereItIsDecidedAndNowhereElse) {
  const std::unique_ptr<Subject> subject = Mutant("mutant:ties-inclusive");
  EXPECT_TRUE(Own(*subject, "vertices-on-samples").Fails());
  EXPECT_FALSE(Own(*subject, "needles").Fails());
}

TEST(Catalogue, TheWorstCaseFailsAgain) {
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin("f32-direct");
  const Cell own = Own(*subject, "needles");
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
      const Cell own = Own(*subject, family);
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
  const std::vector<Cell> cells = Cells(subject, "grids");
  EXPECT_EQ(calls, 4U);
  for (const Cell& cell : cells) {
    EXPECT_EQ(cell.wrong, 4U);
    EXPECT_TRUE(std::isinf(cell.WorstPixels()));
    EXPECT_EQ(cell.why, "killed by signal 11");
  }
}

TEST(Catalogue, ASubjectOfWindowSpaceIsExcusedFromClipSpaceWithTheReason) {
  FakeSubject subject = testing::Sound(RealInfo());
  const Cell own = Own(subject, "mixed-w");
  EXPECT_EQ(own.cases, 0U);
  EXPECT_FALSE(own.why.empty());
}

// Of 100 cases of this family a seed may draw one whose vertices are all finite.
TEST(Catalogue, AFamilyOfWhatTheProfileDoesNotStateIsExcusedForThatAndElseDrawn) {
  FakeSubject one = testing::Sound(SnappedInfo(8));
  const Cell excused = Own(one, "pattern-lines");
  EXPECT_EQ(excused.cases, 0U);
  EXPECT_EQ(excused.why, "the profile says nothing about the family");
  SubjectInfo info = SnappedInfo(8);
  info.profile.pattern = *StandardPattern(4);
  FakeSubject four = testing::Sound(info);
  const Cell drawn = Own(four, "pattern-lines");
  EXPECT_EQ(drawn.cases, 40U) << drawn.why;
  EXPECT_EQ(drawn.wrong, 0U);
  FakeSubject inclusive = testing::Inclusive(info);
  EXPECT_TRUE(Own(inclusive, "pattern-lines").Fails());
}

TEST(Catalogue, AFamilyOfWhichHardlyAnyCaseIsJudgedIsExcusedUnlessThatFails) {
  FakeSubject sound = testing::Sound(SnappedInfo(8));
  FakeSubject wrong(SnappedInfo(8), [](const Scene&, const DrawOptions&, CoverageCounts& counts) {
    for (std::uint32_t& count : counts.front) count += 3;
  });
  std::uint64_t fails = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Cell cell = Cells(sound, "non-finite", 100, seed).front();
    EXPECT_EQ(cell.cases, 0U) << seed;
    EXPECT_EQ(cell.excused, 100U) << seed;
    fails += Cells(wrong, "non-finite", 100, seed).front().wrong;
  }
  EXPECT_GT(fails, 0U);
}

// What a yardstick could not draw is excused with its reason, and four hangs of it end the row.
TEST(Comparison, WhatAYardstickCouldNotDrawIsNotRight) {
  const auto drawing = std::make_shared<Drawing>();
  Case given;
  const Row row{.cases = 9,
                .at = [&](std::uint64_t) { return given; },
                .draw = [&](const CaseAtHand&) { return Drawn{{}, drawing}; }};
  const auto ends_by = [](Stop stop) {
    return Yardstick([stop](const CaseAtHand&) {
      return Judging{"", [stop](const Drawn&) { return Reading{.end = {stop, "why"}}; }};
    });
  };
  const Cell refused = CompareRow(row, {{ends_by(Stop::kRefused)}}).front();
  EXPECT_EQ(refused.cases, 0U);
  EXPECT_EQ(refused.refused, 9U);
  EXPECT_EQ(refused.why, "why");
  const Cell slow = CompareRow(row, {{ends_by(Stop::kTooSlow)}}).front();
  EXPECT_EQ(slow.cases, 0U);
  EXPECT_EQ(slow.excused, 4U);
}

TEST(Catalogue, AWorldIsExhaustedOrExcused) {
  FakeSubject subject = testing::Sound(RealInfo());
  EXPECT_EQ(Own(subject, "pairs-3x3").cases, 0U);
  const Cell whole = Own(subject, "pairs-3x3", 66);
  EXPECT_TRUE(whole.is_exhausted);
  EXPECT_EQ(whole.cases, 6561U);
}

}  // namespace
}  // namespace rasterproof::props
