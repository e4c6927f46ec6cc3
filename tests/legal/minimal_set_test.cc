// What is blamed where no legal model explains an image, against a search through all of them.
#include "legal/minimal_set.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "legal/joint.h"
#include "tests/legal/all_models.h"
#include "tests/share.h"

namespace rasterproof::legal {
namespace {

using testing::Draws;
using testing::ExplainsAt;
using testing::IsJudgedAlike;
using testing::kSide;

TEST(Core, IsOneSampleThatNoModelHasOrAMinimalSetOverAllGrids) {
  Draws draws(20261124);
  int alone = 0;
  int together = 0;
  int over_grids = 0;
  for (int n = 0; n < Cases(1500); ++n) {
    const Scene scene = draws.AScene();
    Profile profile = draws.AProfile();
    if (n % 2 == 0) profile.freedom.least_bits = 0;
    if (!IsJudgedAlike(scene)) continue;
    CoverageCounts mixed = draws.AMixture(scene, profile);
    if (n % 5 == 0) ++mixed.front[draws.Below(kSide * kSide)];
    Observed observed;
    observed.together = &mixed;
    const JointVerdict verdict = JudgeJointly(scene, {profile, scene}, observed);
    if (verdict.legality != Legality::kNotLegal) continue;
    std::vector<std::size_t> samples;
    for (const Requirement& seen : verdict.core->requirements) samples.push_back(seen.sample);
    ASSERT_TRUE(verdict.core->is_minimal);
    ASSERT_FALSE(ExplainsAt(scene, profile, mixed, samples)) << n;
    std::size_t wrong = 0;
    for (std::size_t s = 0; s < mixed.size(); ++s)
      wrong += ExplainsAt(scene, profile, mixed, {s}) ? 0 : 1;
    ASSERT_EQ(verdict.core->wrong_by_themselves, wrong) << n;
    ASSERT_EQ(samples.size() == 1, wrong != 0) << n;
    ASSERT_EQ(verdict.core->wrong.size(), wrong) << n;
    ++(wrong != 0 ? alone : together);
    for (std::size_t k = 0; wrong == 0 && k < samples.size(); ++k) {
      std::vector<std::size_t> others = samples;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      ASSERT_TRUE(ExplainsAt(scene, profile, mixed, others)) << n << ", without " << samples[k];
    }
    over_grids += wrong == 0 && profile.freedom.least_bits ? 1 : 0;
  }
  EXPECT_GT(alone, Cases(50));
  EXPECT_GE(together, Cases(10));
  RecordProperty("over several grids", over_grids);
}

}  // namespace
}  // namespace rasterproof::legal
