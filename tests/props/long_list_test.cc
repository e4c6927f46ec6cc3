// A long list of triangles that cover nothing: ids of a few bits are found as soon as the list is
// longer than they number, and not before.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "core/case.h"
#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "exact/coverage.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/free_choice.h"
#include "subjects/mutants/list_numbers.h"
#include "tests/props/faulty_subjects.h"
#include "tests/props/shown_subject.h"

namespace rasterproof::props {
namespace {

using subjects::mutants::CutTo;
using subjects::mutants::InAFloat;

const Property& LongList() { return *FindProperty("LongListDrawsLikeItsEnd"); }

// A sound rasterizer whose ids are what the function makes of the numbers of triangles.
std::unique_ptr<Subject> WithIds(const std::function<std::size_t(std::size_t)>& id,
                                 std::size_t list_length) {
  std::unique_ptr<Subject> subject = subjects::mutants::Make(
      "ids", "",
      subjects::mutants::FreeStages{
          .profile = subjects::mutants::FixedPointProfile(),
          .coverage = CoverageKind::kPrimitiveIds,
          .id = [id](std::size_t number, std::size_t) { return id(number); }});
  SubjectInfo info = subject->Info();
  info.list_length = list_length;
  subject->JudgeAs(std::move(info));
  return subject;
}

// The case as it would come from a file: it is drawn after the longest list.
Case OneTriangle(const SubjectInfo& info) {
  Case c;
  c.profile = info.profile;
  c.scene.width = c.scene.height = 4;
  c.scene.vertices = {{0, 0}, {0, 4}, {4, 0}};
  c.scene.triangles = {{0, 1, 2}};
  return c;
}

Verdict Judge(Subject& subject) {
  return RunCase(subject, LongList(), OneTriangle(subject.Info()));
}

TEST(ALongList, FindsIdsOfFewBitsWhereItIsLongerThanTheyNumber) {
  for (const int bits : {9, 10, 12}) {
    const std::size_t all = std::size_t{1} << bits;
    for (const auto& id : {std::function([bits](std::size_t n) { return CutTo(n, bits); }),
                           std::function([bits](std::size_t n) { return InAFloat(n, bits); })}) {
      const Verdict holds = Judge(*WithIds(id, all - 1));
      EXPECT_EQ(holds.outcome, Outcome::kHolds) << bits << ": " << holds.message;
      const Verdict found = Judge(*WithIds(id, all));
      ASSERT_EQ(found.outcome, Outcome::kViolated) << bits;
      EXPECT_EQ(found.witness->triangle, 0);
      EXPECT_NE(found.message.find("after " + std::to_string(all + 1)), std::string::npos)
          << found.message;
    }
  }
}

TEST(ALongList, ThatIsUsualDoesNotReach24Bits) {
  for (const auto& id : {std::function([](std::size_t n) { return CutTo(n, 24); }),
                         std::function([](std::size_t n) { return InAFloat(n, 24); })}) {
    EXPECT_EQ(Judge(*WithIds(id, kUsualListLength)).outcome, Outcome::kHolds);
  }
}

TEST(NumbersInAFloat, AreThoseOfFloat32At24Bits) {
  for (std::uint32_t n = (1U << 24) - 5; n < (1U << 24) + 300; ++n) {
    EXPECT_EQ(InAFloat(n, 24), static_cast<std::size_t>(static_cast<float>(n))) << n;
    EXPECT_EQ(InAFloat(16 * n + 7, 24), static_cast<std::size_t>(static_cast<float>(16 * n + 7)));
  }
}

TEST(ALongList, IsOfTrianglesThatCoverNothing) {
  bool has_drawn = false;
  FakeSubject subject = testing::ShownSubject(
      CoverageKind::kFacingCounts, [](std::span<const Triangle>, std::size_t) { return true; },
      [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        if (scene.triangles.size() == 256) {
          has_drawn = true;
          Scene leading = scene;
          leading.triangles.pop_back();
          const CoverageCounts drawn = exact::Coverage(leading, Profile{}, options);
          for (std::size_t k = 0; k < drawn.size(); ++k) EXPECT_EQ(drawn.Count(k), 0U);
        }
        counts += exact::Coverage(scene, Profile{}, options);
      });
  EXPECT_EQ(Judge(subject).outcome, Outcome::kHolds);
  EXPECT_TRUE(has_drawn);
}

TEST(ALongList, IsDrawnInOneOf32Cases) {
  std::size_t longest = 0;
  std::size_t draws = 0;
  FakeSubject subject = testing::ShownSubject(
      CoverageKind::kFacingCounts, [](std::span<const Triangle>, std::size_t) { return true; },
      [&](const Scene& scene, const DrawOptions&, CoverageCounts&) {
        ++draws;
        if (scene.triangles.size() > kUsualListLength) ++longest;
      });
  for (std::uint64_t k = 0; k < 32; ++k) {
    Case c = OneTriangle(subject.Info());
    c.name = CaseName{"grids", k, 1};
    RunCase(subject, LongList(), c);
  }
  EXPECT_EQ(longest, 1U);
  EXPECT_EQ(draws, 32U * 4 + 1);
}

}  // namespace
}  // namespace rasterproof::props
