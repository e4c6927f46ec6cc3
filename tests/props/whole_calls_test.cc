// Properties that compare a draw with another compare whole calls, as the subject shows them.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/profile.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"
#include "tests/props/shown_subject.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::DrawRight;
using testing::ShownSubject;
using testing::Takes;

constexpr std::array kShown{CoverageKind::kFacingCounts, CoverageKind::kCounts, CoverageKind::kMask,
                            CoverageKind::kPrimitiveIds};

bool TakesAll(std::span<const Triangle> /*call*/, std::size_t /*number*/) { return true; }

// A vertex list that is kept from one triangle to the next, and compared by its first entry alone.
bool TakesNoneWithTheFirstVertexOfTheOneBefore(std::span<const Triangle> call, std::size_t number) {
  return number == 0 || call[number][0] != call[number - 1][0];
}

PropertyResult RunWith(CoverageKind kind, const Takes& takes, std::string_view property,
                       std::uint64_t cases) {
  FakeSubject subject = ShownSubject(kind, takes, DrawRight);
  return RunCampaign(subject, *FindProperty(property), {.cases = cases, .shrink_budget = 0});
}

TEST(WholeCalls, ShowWhatATriangleTakesFromTheOneBefore) {
  for (const CoverageKind kind : kShown) {
    const auto seen = [&](std::string_view property) {
      return RunWith(kind, TakesNoneWithTheFirstVertexOfTheOneBefore, property, 60);
    };
    for (const std::string_view property :
         {"TriangleOrderKeepsCoverage", "VertexRotationKeepsCoverage",
          "DuplicatedVerticesKeepCoverage", "BadTrianglesPoisonNoOthers"}) {
      EXPECT_EQ(seen(property).outcome, Outcome::kViolated)
          << property << " of kind " << static_cast<int>(kind);
    }
  }
}

TEST(WholeCalls, OfASoundSubjectAreEqual) {
  constexpr std::uint64_t kCases = Cases<std::uint64_t>(40);
  for (const CoverageKind kind : kShown) {
    for (const std::string_view property :
         {"TriangleOrderKeepsCoverage", "VertexRotationKeepsCoverage", "ReversalSwapsFacing",
          "DuplicatedVerticesKeepCoverage", "ScissorOnlyCutsCoverage", "CullingRemovesOneFacing",
          "IntegerTranslationMovesCoverage", "TileSizeKeepsCoverage", "TargetWidthKeepsCoverage",
          "TargetHeightKeepsCoverage", "DrawStaysInsideItsTarget", "BadTrianglesPoisonNoOthers",
          "TilesDrawnApartEqualTheWhole", "EqualDrawsGiveEqualCounts"}) {
      const PropertyResult result = RunWith(kind, TakesAll, property, kCases);
      EXPECT_EQ(result.outcome, Outcome::kHolds)
          << property << " of kind " << static_cast<int>(kind) << ": " << result.message;
    }
  }
}

// A call is drawn as if it culled nothing, or the other facing.
TEST(WholeCalls, ShowWhatIsCulledWithoutFacings) {
  for (const CoverageKind kind : kShown) {
    for (const bool nothing : {true, false}) {
      FakeSubject subject = ShownSubject(
          kind, TakesAll,
          [nothing](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            DrawOptions other = options;
            if (options.cull != Cull::kNone) {
              other.cull = nothing                        ? Cull::kNone
                           : options.cull == Cull::kFront ? Cull::kBack
                                                          : Cull::kFront;
            }
            DrawRight(scene, other, counts);
          });
      const PropertyResult result = RunCampaign(subject, *FindProperty("CullingRemovesOneFacing"),
                                                {.cases = 60, .shrink_budget = 0});
      EXPECT_EQ(result.outcome, Outcome::kViolated) << static_cast<int>(kind) << nothing;
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
