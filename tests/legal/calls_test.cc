// One family for several calls, against each family by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "exact/coverage.h"
#include "legal/choices.h"
#include "legal/joint.h"
#include "model/target_profile.h"

namespace rasterproof::legal::calls_test {
namespace {

constexpr int kTarget = 12;

Scene AScene(std::mt19937& random, int triangles, int bits) {
  Scene scene;
  scene.width = kTarget;
  scene.height = kTarget;
  std::uniform_int_distribution<int> place(0, kTarget << bits);
  for (int k = 0; k < 3 * triangles; ++k) {
    const double x = std::ldexp(place(random), -bits);
    const double y = std::ldexp(place(random), -bits);
    scene.vertices.push_back({x, y, 0, 1});
    if (k % 3 == 2) scene.triangles.push_back({k - 2, k - 1, k});
  }
  return scene;
}

Profile AProfile() {
  Profile profile;
  profile.snap = {3};
  profile.freedom.least_bits = 1;
  profile.freedom.any_rounding = true;
  return profile;
}

CoverageCounts DrawnWith(const Scene& scene, int bits) {
  Profile profile = AProfile();
  profile.freedom = {};
  profile.snap = {bits};
  return exact::Coverage(scene, profile, {});
}

// By the family alone.
bool Explains(const Family& family, const Scene& scene, const CoverageCounts& counts) {
  Profile profile = AProfile();
  profile.snap = family.grid;
  profile.freedom.least_bits.reset();
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(scene, {profile, scene}, observed).legality == Legality::kLegal;
}

std::vector<Family> FamiliesOfBoth(const Scene& a, const Scene& b, const TargetProfile& profile) {
  Scene both = a;
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  return FamiliesOf(profile, both);
}

TEST(Calls, HaveOneFamilyWhereOneExplainsEachOfThem) {
  std::mt19937 random(5);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene a = AScene(random, 2, 2 + n % 4);
    const Scene b = AScene(random, 2, 4);
    const CoverageCounts of_a = DrawnWith(a, 1 + n % 3);
    const CoverageCounts of_b = DrawnWith(b, n % 2 == 0 ? 1 + n % 3 : 4);
    const TargetProfile profile(AProfile(), kTarget, kTarget);
    std::vector<Call> calls(2);
    calls[0].scene = &a;
    calls[0].observed.together = &of_a;
    calls[1].scene = &b;
    calls[1].observed.together = &of_b;
    const CallsVerdict verdict = JudgeCalls(calls, profile);
    const std::vector<Family> families = FamiliesOfBoth(a, b, profile);
    const bool is_legal = std::ranges::any_of(families, [&](const Family& family) {
      return Explains(family, a, of_a) && Explains(family, b, of_b);
    });
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ++(is_legal ? legal : illegal);
    if (is_legal) {
      EXPECT_TRUE(Explains(verdict.family, a, of_a) && Explains(verdict.family, b, of_b)) << n;
      continue;
    }
    ASSERT_EQ(verdict.explaining.size(), 2U);
    EXPECT_EQ(verdict.conflict, (std::vector<std::size_t>{0, 1})) << n;
    for (const Family& family : verdict.explaining[0]) EXPECT_TRUE(Explains(family, a, of_a)) << n;
    for (const Family& family : verdict.explaining[1]) EXPECT_FALSE(Explains(family, a, of_a)) << n;
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 20);
}

TEST(Calls, AreExplainedByTheFamiliesThatDoSoAlone) {
  std::mt19937 random(6);
  for (int n = 0; n < 100; ++n) {
    const Scene scene = AScene(random, 2, 4);
    const CoverageCounts counts = DrawnWith(scene, 1 + n % 4);
    const TargetProfile profile(AProfile(), kTarget, kTarget);
    Call call{.scene = &scene, .observed = {}};
    call.observed.together = &counts;
    const std::vector<Family> explaining = ExplainingFamilies(call, profile);
    const auto explains = [&](const Family& family) { return Explains(family, scene, counts); };
    const std::vector<Family> all = FamiliesOf(profile, scene);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(explaining.size()), std::ranges::count_if(all, explains))
        << n;
    EXPECT_TRUE(std::ranges::all_of(explaining, explains)) << n;
  }
}

}  // namespace
}  // namespace rasterproof::legal::calls_test
