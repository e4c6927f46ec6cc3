// A mesh that is too large to be drawn triangle by triangle is judged as it is shown.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "props/judging/as_shown.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"
#include "tests/props/shown_subject.h"

namespace rasterproof::props {
namespace {

using testing::DrawRight;
using testing::ShownSubject;

bool TakesAll(std::span<const Triangle> /*call*/, std::size_t /*number*/) { return true; }

constexpr int kSide = 512;

// A sheet that lies in the middle of the target, and, folded over, once more on top of itself.
Case Sheet(int columns, int rows, bool folded) {
  Case c;
  c.profile = testing::RealInfo().profile;
  c.scene.width = c.scene.height = kSide;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) c.scene.vertices.push_back({64.25 + 8 * x, 64.5 + 8 * y});
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const std::int32_t at = y * (columns + 1) + x;
      const std::int32_t below = at + columns + 1;
      c.scene.triangles.push_back({at, below, at + 1});
      c.scene.triangles.push_back({at + 1, below, below + 1});
    }
  }
  if (!folded) return c;
  const std::vector<Triangle> once = c.scene.triangles;
  for (const Triangle& t : once) c.scene.triangles.push_back({t[0], t[2], t[1]});
  return c;
}

bool IsLarge(const Case& c) {
  return IsJudgedAsShown(CoverageKind::kMask, c.scene.triangles.size(),
                         CoverageCounts::Size(kSide, kSide, 1));
}

// Turns the answer at one sample of what it draws around.
FakeSubject WrongAt(CoverageKind kind, int x, int row) {
  return ShownSubject(kind, TakesAll,
                      [=](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                        DrawRight(scene, options, counts);
                        const std::size_t k = counts.Index(x, row);
                        const bool covers = counts.Count(k) != 0;
                        counts.front[k] = covers ? 0 : 1;
                        counts.back[k] = 0;
                      });
}

Verdict Judge(Subject& subject, std::string_view property, const Case& c) {
  return RunCase(subject, *FindProperty(property), c);
}

TEST(ALargeMesh, IsDrawnInOneCallAndJudgedByWhatIsCovered) {
  const Case sheet = Sheet(24, 24, true);
  ASSERT_TRUE(IsLarge(sheet));
  for (const CoverageKind kind : {CoverageKind::kMask, CoverageKind::kPrimitiveIds}) {
    FakeSubject sound = ShownSubject(kind, TakesAll, DrawRight);
    const Verdict holds = Judge(sound, "CoverageEqualsTheModel", sheet);
    EXPECT_EQ(holds.outcome, Outcome::kHolds) << holds.message;
    EXPECT_EQ(sound.draws, 1U);
    for (const auto& [x, row] : {std::array{100, 100}, std::array{3, 500}}) {
      FakeSubject wrong = WrongAt(kind, x, row);
      const Verdict found = Judge(wrong, "CoverageEqualsTheModel", sheet);
      ASSERT_EQ(found.outcome, Outcome::kViolated);
      EXPECT_EQ(found.witness->x, x);
      EXPECT_EQ(found.witness->y, row);
    }
  }
}

TEST(ALargeMesh, ThatIsCountedIsDrawnByItsTwoSides) {
  FakeSubject counts = ShownSubject(CoverageKind::kCounts, TakesAll, DrawRight);
  EXPECT_EQ(Judge(counts, "ClosedMeshCancels", Sheet(24, 24, true)).outcome, Outcome::kHolds);
  EXPECT_EQ(counts.draws, 2U);
}

TEST(ALargeMesh, SaysNothingOfFacingsWhereNoneAreShown) {
  const Case sheet = Sheet(24, 24, true);
  for (const std::string_view property :
       {"ClosedMeshCancels", "SignedCoverageEqualsTheWindingNumber"}) {
    FakeSubject mask = ShownSubject(CoverageKind::kMask, TakesAll, DrawRight);
    const Verdict verdict = Judge(mask, property, sheet);
    EXPECT_EQ(verdict.outcome, Outcome::kNotExercised) << property;
    EXPECT_EQ(verdict.message, kJudgedAsShown);
    EXPECT_EQ(mask.draws, 0U);
    FakeSubject facings = ShownSubject(CoverageKind::kFacingCounts, TakesAll, DrawRight);
    EXPECT_EQ(Judge(facings, property, sheet).outcome, Outcome::kHolds) << property;
  }
}

TEST(ALargeMesh, HasGapsThatAreSeenAndOverlapsThatAreNot) {
  const Case sheet = Sheet(24, 24, false);
  ASSERT_TRUE(IsLarge(sheet));
  const auto judged = [&](FakeSubject subject) {
    return Judge(subject, "EmbeddedMeshSamplesAreCoveredOnce", sheet);
  };
  const Verdict sound = judged(ShownSubject(CoverageKind::kMask, TakesAll, DrawRight));
  EXPECT_EQ(sound.outcome, Outcome::kNotExercised);
  EXPECT_EQ(sound.message, kJudgedAsShown);
  EXPECT_EQ(judged(WrongAt(CoverageKind::kMask, 100, 100)).outcome, Outcome::kViolated);
  EXPECT_EQ(judged(WrongAt(CoverageKind::kMask, 3, 500)).outcome, Outcome::kViolated);
}

}  // namespace
}  // namespace rasterproof::props
