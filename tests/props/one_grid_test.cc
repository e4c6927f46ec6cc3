// One grid for all calls on a target: what changes it with the call is found, and what changes it
// with the target, rounds as it likes or has no grid is not accused.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/grids_left.h"
#include "core/profile.h"
#include "core/result.h"
#include "exact/coverage.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props::one_grid_test {
namespace {

const Property& OneGrid() { return *FindProperty("OneGridExplainsEveryCall"); }

PropertyResult CampaignOn(Subject& subject, std::uint64_t seed, std::uint64_t cases) {
  return RunCampaign(subject, OneGrid(), {.seed = seed, .cases = cases, .shrink_budget = 20});
}

PropertyResult CampaignOn(const std::string& name, std::uint64_t seed, std::uint64_t cases) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
  return CampaignOn(*subject, seed, cases);
}

TEST(OneGrid, IsMissedByWhatChangesItWithTheCall) {
  for (const char* name :
       {"mutant:vulkan-grid-by-list", "mutant:gl-grid-by-list", "mutant:vulkan-grid-by-crowd",
        "mutant:vulkan-grid-by-vertices", "mutant:vulkan-grid-by-order"}) {
    for (std::uint64_t seed = 1; seed <= Cases(3U); ++seed) {
      const PropertyResult result = CampaignOn(name, seed, 50);
      EXPECT_EQ(result.outcome, Outcome::kViolated) << name << ", seed " << seed;
      EXPECT_EQ(result.authority, Authority::kClause) << name;
      EXPECT_NE(result.message.find("no legal grid explains these calls together"),
                std::string::npos)
          << result.message;
    }
  }
}

TEST(OneGrid, SaysWhichBitsEachCallNeeds) {
  const PropertyResult result = CampaignOn("mutant:vulkan-grid-by-list", 1, 50);
  ASSERT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_NE(result.message.find(" subpixel bits; "), std::string::npos) << result.message;
}

TEST(OneGrid, IsFoundInWhateverOneDeviceDoes) {
  for (const char* name :
       {"legal:gl-bits-by-viewport", "legal:vulkan-bits-by-viewport", "legal:vulkan-rounds-by-axis",
        "legal:vulkan-4-bits", "legal:vulkan-4-bits-floor", "legal:vulkan-5-bits-truncate",
        "legal:vulkan-8-bits-ceiling", "legal:vulkan-17-bits", "legal:vulkan-farthest-counts",
        "legal:vulkan-farthest-mask", "legal:vulkan-farthest-ids", "legal:gl-4-bits-floor",
        "legal:vulkan-owner-by-sample", "legal:vulkan-owner-by-tile", "legal:gl-clips-to-target",
        "legal:vulkan-flat-drawn", "legal:gl-owner-by-direction"}) {
    for (std::uint64_t seed = 1; seed <= Cases(5U); ++seed) {
      const PropertyResult result = CampaignOn(name, seed, Cases(60U));
      EXPECT_EQ(result.outcome, Outcome::kHolds)
          << name << ", seed " << seed << ": " << result.message;
    }
  }
}

TEST(OneGrid, IsLeftByItsRuler) {
  const PropertyResult result = CampaignOn("legal:vulkan-4-bits", 1, 60);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_NE(result.message.find("left of all grids: 4 subpixel bits"), std::string::npos)
      << result.message;
}

TEST(OneGrid, MayChangeWithTheSizeOfTheTargetAndThatIsAnAssumption) {
  for (const char* name : {"legal:gl-bits-by-viewport", "legal:vulkan-bits-by-viewport"}) {
    const PropertyResult result = CampaignOn(name, 1, 300);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
    EXPECT_NE(result.message.find("it is assumed that it may change with the size"),
              std::string::npos)
        << result.message;
  }
}

TEST(OneGrid, IsNotAskedOfWhomNothingRequiresIt) {
  const PropertyResult webgpu = CampaignOn("legal:webgpu-grid-by-call", 1, 20);
  EXPECT_EQ(webgpu.outcome, Outcome::kNotApplicable);
  EXPECT_NE(webgpu.message.find("every call may have a grid of its own"), std::string::npos)
      << webgpu.message;
  EXPECT_EQ(CampaignOn("legal:d3d11-snap-by-call", 1, 20).outcome, Outcome::kNotApplicable);
}

TEST(OneGrid, OfShardsIsThatOfTheWhole) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant("legal:gl-bits-by-viewport");
  const PropertyResult whole = RunCampaign(*subject, OneGrid(), {.cases = 60});
  PropertyResult sum = RunCampaign(*subject, OneGrid(), {.cases = 20});
  sum += RunCampaign(*subject, OneGrid(), {.cases = 40, .first_case = 20});
  ASSERT_EQ(sum.grids.size(), whole.grids.size());
  for (std::size_t k = 0; k < sum.grids.size(); ++k) {
    EXPECT_TRUE(sum.grids[k].IsOfTheSameTarget(whole.grids[k])) << k;
    EXPECT_EQ(sum.grids[k].cases, whole.grids[k].cases) << k;
    EXPECT_EQ(sum.grids[k].left, whole.grids[k].left) << k;
  }
}

// Which side is the front is one for a device, too.
TEST(OneFront, IsMissedByWhatTurnsItWithTheNumberOfTriangles) {
  SubjectInfo info = testing::SnappedInfo(8);
  info.profile = *PresetProfile("vulkan");
  const Profile drawn = *PresetProfile("vulkan-canonical");
  for (std::uint64_t seed = 1; seed <= Cases(3U); ++seed) {
    FakeSubject turning(
        info, [drawn](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
          CoverageCounts more = exact::Coverage(scene, drawn, options);
          if (scene.triangles.size() > 1) std::swap(more.front, more.back);
          counts += more;
        });
    const PropertyResult result = RunCampaign(turning, *FindProperty("FacingIsOneAtAllSamples"),
                                              {.seed = seed, .cases = 200, .shrink_budget = 20});
    EXPECT_EQ(result.outcome, Outcome::kViolated) << "seed " << seed << ": " << result.message;
  }
}

TEST(GridsLeft, AreToldInWords) {
  GridsLeft grids;
  EXPECT_EQ(grids.Text(), "none");
  grids.Add(8);
  EXPECT_EQ(grids.Text(), "8");
  for (const int bits : {4, 5, 6}) grids.Add(bits);
  EXPECT_EQ(grids.Text(), "4 to 6, 8");
  grids.Add(GridsLeft::kMostBits);
  EXPECT_EQ(grids.Text(), "4 to 6, 8, no grid");
  for (int bits = 10; bits < GridsLeft::kMostBits; ++bits) grids.Add(bits);
  EXPECT_EQ(grids.Text(), "4 to 6, 8, 10 or more");
}

}  // namespace
}  // namespace rasterproof::props::one_grid_test
