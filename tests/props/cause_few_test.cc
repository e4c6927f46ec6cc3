// A cause is named by four different scenes drawn wrong, not by fewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "props/cause/suspect.h"
#include "tests/props/planted_cause.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using subjects::mutants::FixedStages;
using subjects::mutants::GridTriangle;
using subjects::mutants::Sample;

// A triangle on a target so high that no case around it is drawn.
Case Tall(int height, double top, double size) {
  return TrianglesOf(1, height, {{-1, top, 0, 1}, {3, top, 0, 1}, {-1, top + size, 0, 1}});
}
std::vector<Case> TallOnes(int count) {
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k) cases.push_back(Tall(16400, 9000, 8.25 + k));
  return cases;
}

// Loses what lies from row 8192 on, and on targets of an odd height some rows more, as no
// suspect does.
FixedStages LosingRows() {
  FixedStages stages;
  stages.times = [](const Sample& s, const GridTriangle&) {
    const bool is_odd = s.height == 16401 && 7 * s.row % 11 == 0;
    return s.row >= 8192 || is_odd ? 0U : 1U;
  };
  return stages;
}

Cause OfTallOnes(const std::vector<Case>& cases) {
  const Causes found = ExplainPlanted(LosingRows(), {cases});
  EXPECT_EQ(found.all.size(), 1U);
  const Cause cause = found.all.empty() ? Cause() : found.all.front();
  // Where it is not named it is told all the same.
  EXPECT_EQ(cause.kind, cause.rests_on_few ? CauseKind::kUnexplained : CauseKind::kModel);
  EXPECT_EQ(cause.name, cause.rests_on_few ? "" : "target-border");
  EXPECT_EQ(cause.what, std::vector<std::string>{"never draws pixels from row 8192 on"});
  return cause;
}

TEST(FewDraws, NameNoCauseBelowFourScenes) {
  const Cause one = OfTallOnes(TallOnes(1));
  const std::size_t found = one.wrong_scenes - 1;  // by the search for more
  ASSERT_LE(found, 2U);
  EXPECT_TRUE(one.rests_on_few);
  EXPECT_TRUE(one.only_with.empty());
  if (kOneCaseIn > 1) return;  // the same code as of one scene
  const Cause three = OfTallOnes(TallOnes(3 - static_cast<int>(found)));
  EXPECT_EQ(three.wrong_scenes, 3U);
  EXPECT_TRUE(three.rests_on_few);
  const Cause four = OfTallOnes(TallOnes(4 - static_cast<int>(found)));
  EXPECT_EQ(four.wrong_scenes, 4U);
  EXPECT_FALSE(four.rests_on_few);
  // No scene is one more for being drawn again.
  const Cause again = OfTallOnes(std::vector<Case>(5, TallOnes(1).front()));
  EXPECT_EQ(again.wrong_scenes, one.wrong_scenes);
}

TEST(FewDraws, NameNoCauseOfAPartBesideMoreOthers) {
  if (kOneCaseIn > 1) return;  // other tests of causes have parts, of small targets
  std::vector<Case> odd;
  for (int k = 0; k < 4; ++k) odd.push_back(Tall(16401, 0, 28.25 + k));
  const Causes found = ExplainPlanted(LosingRows(), {TallOnes(3), odd});
  ASSERT_FALSE(found.all.empty());
  // What explains a part of the draws, and leaves the others to no one, is not named at all.
  for (const Cause& cause : found.all) {
    EXPECT_EQ(cause.kind, CauseKind::kUnexplained);
    EXPECT_TRUE(cause.what.empty());
  }
}

TEST(FewDraws, OfAPartAreEnoughIfFourOrHalf) {
  EXPECT_TRUE(AreFewScenes(CauseKind::kPart, 3, 7));
  EXPECT_FALSE(AreFewScenes(CauseKind::kPart, 3, 6));
  EXPECT_FALSE(AreFewScenes(CauseKind::kPart, 4, 100));
  EXPECT_TRUE(AreFewScenes(CauseKind::kModel, 3, 3));
  EXPECT_FALSE(AreFewScenes(CauseKind::kModel, 4, 4));
}

TEST(CauseNames, AreThoseOfTheSuspectsAndMore) {
  const std::vector<std::string_view> names = CauseNames();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  std::set<std::string> used;
  for (const char* preset : {"real", "d3d11-canonical", "gl-canonical-4x"}) {
    for (const Suspect& suspect : SuspectsOf(*PresetProfile(preset))) used.insert(suspect.cause);
  }
  EXPECT_GT(used.size(), 20U);
  for (const std::string& name : used)
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
}

TEST(FindCauses, SaysThatItWasCutShort) {
  EXPECT_TRUE(ExplainPlanted(LosingRows(), {TallOnes(1)}, 1e-9).is_cut_short);
  EXPECT_FALSE(ExplainPlanted(LosingRows(), {TallOnes(1)}).is_cut_short);
}

}  // namespace
}  // namespace rasterproof::props
