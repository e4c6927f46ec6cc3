#include "tool/plan/plan_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/bench.h"
#include "bench/contender.h"
#include "bench/errors.h"
#include "bench/family.h"
#include "core/error.h"

namespace rasterproof::tool {
namespace {

bench::FamilyInput FamilyNamed(std::string_view name) {
  const auto kinds = bench::FamilyKinds();
  return bench::MakeFamily(*std::ranges::find(kinds, name, &bench::FamilyKind::name),
                           bench::FamilySize::kQuick, 1);
}

// What was drawn is never farther off than what is proved; of the affine form, which is off, the
// proof says that it may be.
TEST(ProvedErrorOf, BoundsWhatIsSeen) {
  bool saw_any = false;
  for (const std::string_view name : {"far", "grazing", "snapped-8", "walks"}) {
    const bench::FamilyInput family = FamilyNamed(name);
    const bench::JudgedTriangles judged(family.scene, 200'000);
    bench::CoverageJudge judge(family, judged);
    for (const auto& contender : bench::OwnContenders(bench::ContenderChoice::kQuick)) {
      if (contender->WhyNot(family) || !contender->DrawsAlone()) continue;
      const ProvedError proved = ProvedErrorOf(contender->method().name, family.scene);
      if (std::isnan(proved.pixels)) continue;
      contender->Load(family);
      const BenchErrors& seen = judge.Of(*contender).real;
      EXPECT_LE(seen.displacement, proved.pixels) << contender->method().name << " on " << name;
      EXPECT_EQ(seen.lost, 0U) << contender->method().name << " on " << name;
      saw_any = saw_any || seen.displacement > 0;
    }
  }
  EXPECT_TRUE(saw_any);
}

TEST(ProvedErrorOf, IsZeroOfWhatIsExactAndHalfAStepsDiagonalOfWhatSnaps) {
  const Scene scene = FamilyNamed("mesh").scene;
  EXPECT_EQ(ProvedErrorOf("spans-exact", scene).pixels, 0);
  EXPECT_EQ(ProvedErrorOf("kernel-exact", scene).pixels, 0);
  EXPECT_NEAR(ProvedErrorOf("i64-snap8", scene).pixels, std::sqrt(0.5) / 256, 1e-12);
  EXPECT_GT(ProvedErrorOf("f32-affine", scene).pixels, ProvedErrorOf("f32-direct", scene).pixels);
}

TEST(ProvedErrorOf, StatesNothingWhereNothingIsProved) {
  Scene scene = FamilyNamed("mesh").scene;
  for (const std::string_view name :
       {"kernel-tiles", "kernel-scanline", "kernel-exact-unsafe", "f32-incremental", "nobody's"}) {
    EXPECT_TRUE(std::isnan(ProvedErrorOf(name, scene).pixels)) << name;
  }
  scene.vertices[0].x = 0x1p20;  // beyond what fixed tiles draw
  EXPECT_TRUE(std::isnan(ProvedErrorOf("kernel-fixed-tiles", scene).pixels));
  EXPECT_TRUE(std::isnan(ProvedErrorOf("i32-snap4", scene).pixels));
  EXPECT_EQ(ProvedErrorOf("kernel-exact", scene).pixels, 0);
}

BenchResult TwoFamilies() {
  BenchResult bench;
  for (const std::string name : {"kernel-exact", "f32-direct", "f32-incremental"}) {
    BenchMethod& method = bench.methods.emplace_back();
    method.name = name;
    method.target = "compiler";
    method.sink = "facing";
  }
  for (const std::uint64_t covered : {20U, 100'000U}) {
    BenchFamily& family = bench.families.emplace_back();
    family.name = covered == 20 ? "small" : "large";
    family.triangles = 10;
    family.covered = covered;
    family.twin = 2;
    const auto at = static_cast<std::uint32_t>(bench.families.size() - 1);
    for (const std::uint32_t method : {0U, 1U}) {
      BenchRow& row = bench.rows.emplace_back();
      row.family = at;
      row.method = method;
      row.time.median = (method == 0 ? 3e-8 : 1e-8) * static_cast<double>(covered);
    }
  }
  return bench;
}

TEST(ErrorChoices, MeetAStatedErrorOrDoNot) {
  const BenchResult bench = TwoFamilies();
  const Scene scene = FamilyNamed("px5").scene;
  const std::size_t family = NearestFamily(bench, scene, "bench.json");
  EXPECT_EQ(bench.families[family].name, "small");
  const auto loose = ErrorChoices(bench, family, scene, 1e-2);
  ASSERT_EQ(loose.size(), 2U);
  EXPECT_EQ(loose[0].method, "f32-direct");  // the cheapest
  EXPECT_TRUE(loose[0].meets);
  const auto strict = ErrorChoices(bench, family, scene, 0);
  EXPECT_FALSE(strict[0].meets);
  EXPECT_TRUE(strict[1].meets);
}

TEST(NearestFamily, RefusesABenchOfOtherCoordinates) {
  BenchResult bench = TwoFamilies();
  for (BenchFamily& family : bench.families) family.is_clip_space = true;
  EXPECT_THROW(NearestFamily(bench, FamilyNamed("px5").scene, "bench.json"), InputError);
}

}  // namespace
}  // namespace rasterproof::tool
