// The joint verdict where clipping may move an edge that leaves the target.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "legal/joint.h"

namespace rasterproof::legal {
namespace {

// Two triangles on either side of an edge from (0, 4) that leaves the target for (64, 8).
Scene LeavingNeighbours() {
  Scene scene;
  scene.width = 8;
  scene.height = 8;
  scene.vertices = {{0, 4}, {64, 8}, {0, 8}, {64, 0}};
  scene.triangles = {{0, 1, 2}, {0, 3, 1}};
  return scene;
}

// `below`, and `above`: how often each sample is covered under y = 4 + x / 16, and over it, but for
// the sample (column, 4), which `there` triangles cover.
Legality LegalityOfLeaving(const Profile& profile, int column, std::uint32_t there) {
  CoverageCounts counts(8, 8, 1);
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < 8; ++x) {
      const double at = row + 0.5;
      const bool lower = at > 4 + (x + 0.5) / 16;
      const bool upper = !lower && at > 4 - (x + 0.5) / 16;
      counts.front[counts.Index(x, row, 0)] = lower || upper ? 1 : 0;
    }
  }
  counts.front[counts.Index(column, 4, 0)] = there;
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(LeavingNeighbours(), profile, observed).legality;
}

TEST(JudgeJointly, LetsClippingMoveAnEdgeThatLeavesByLessThanAStep) {
  Profile set = *PresetProfile("vulkan");
  // (7.5, 4.5) is 1/32 of a pixel below the edge, half a step of the coarsest grid.
  for (const std::uint32_t there : {0U, 1U, 2U}) {
    EXPECT_EQ(LegalityOfLeaving(set, 7, there), Legality::kLegal) << there;
  }
  // (3.5, 4.5) is more than four steps off: a gap there, or an overlap, is none of clipping's.
  EXPECT_EQ(LegalityOfLeaving(set, 3, 1), Legality::kLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 2), Legality::kNotLegal);
  // (6.5, 4.5) is 3/32 off: a step and a half.
  EXPECT_EQ(LegalityOfLeaving(set, 6, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 6, 2), Legality::kNotLegal);
}

TEST(JudgeJointly, KeepsEdgesWithinTheGuardBand) {
  Profile set = *PresetProfile("vulkan");
  for (const std::optional<GuardBand>& band :
       {std::optional<GuardBand>(), std::optional<GuardBand>(AroundTarget{64}),
        std::optional<GuardBand>(WindowBox{-1, -1, 64, 9})}) {
    set.guard_band = band;
    EXPECT_EQ(LegalityOfLeaving(set, 7, 1), Legality::kLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 2), Legality::kNotLegal);
  }
  set.guard_band = AroundTarget{55};
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kLegal);
  set = *PresetProfile("d3d11");  // a step is 1/256
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
}

}  // namespace
}  // namespace rasterproof::legal
