#include "bench/bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bench/contender.h"
#include "bench/errors.h"
#include "bench/exact_triangles.h"
#include "bench/family.h"
#include "core/ulp.h"
#include "exact/coverage.h"
#include "library/kernels/kernel.h"
#include "model/segment_distance.h"
#include "report/claims.h"

namespace rasterproof::bench {
namespace {

TEST(Families, AreOfFloat32AndTheSameForTheSameSeed) {
  std::set<std::string_view> names;
  for (const FamilyKind& kind : FamilyKinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    const FamilyInput family = MakeFamily(kind, FamilySize::kQuick, 1);
    EXPECT_FALSE(family.scene.triangles.empty()) << kind.name;
    for (const Vertex& v : family.scene.vertices) {
      EXPECT_TRUE(IsFloat32(v.x) && IsFloat32(v.y) && IsFloat32(v.w)) << kind.name;
    }
    EXPECT_EQ(family.KernelsDrawIt(), !family.scene.clip_space) << kind.name;
    EXPECT_EQ(family.ClipKernelsDrawIt(), family.scene.clip_space) << kind.name;
    EXPECT_EQ(MakeFamily(kind, FamilySize::kQuick, 1).scene, family.scene) << kind.name;
    EXPECT_EQ(MakeFamily(kind, FamilySize::kQuick, 2).scene != family.scene,
              kind.is_random || kind.name == "fan" || kind.name == "mesh" || kind.is_constructed ||
                  kind.name.starts_with("snapped") || kind.name == "four-samples")
        << kind.name;
  }
  EXPECT_GE(names.size(), 12U);
}

// Of one family, by the methods named; rounds that measure nothing.
BenchResult RunOnce(const FamilyInput& family, const std::vector<std::string>& names) {
  auto contenders = OwnContenders(ContenderChoice::kQuick);
  std::erase_if(contenders, [&](const auto& contender) {
    const std::string& name = contender->method().name;
    return !IsBaseline(name) && std::ranges::find(names, name) == names.end();
  });
  BenchOptions options;
  options.seconds_per_family = 0;
  options.least_rounds = 1;
  options.judged_pixels = 200'000;
  BenchResult result;
  RunFamily(family, contenders, options, result);
  return result;
}
BenchResult RunOnce(std::string_view family_name, const std::vector<std::string>& names) {
  const auto kinds = FamilyKinds();
  const auto kind = std::ranges::find(kinds, family_name, &FamilyKind::name);
  return RunOnce(MakeFamily(*kind, FamilySize::kQuick, 1), names);
}

const BenchRow& RowOf(const BenchResult& result, std::string_view name) {
  return *std::ranges::find_if(
      result.rows, [&](const BenchRow& row) { return result.methods[row.method].name == name; });
}

TEST(RunFamily, FindsWhatEachMethodGetsWrongOnTies) {
  const BenchResult result =
      RunOnce("ties", {"textbook", "spans-exact", "kernel-exact", "kernel-exact-unsafe"});
  EXPECT_EQ(RowOf(result, "spans-exact").real.Wrong(), 0U);
  EXPECT_EQ(RowOf(result, "kernel-exact").real.Wrong(), 0U);
  EXPECT_GT(RowOf(result, "textbook").leaks.overlaps, 0U);
  EXPECT_EQ(RowOf(result, "textbook").leaks.gaps, 0U);
  EXPECT_EQ(RowOf(result, "textbook").real.displacement, 0);
  EXPECT_GT(RowOf(result, "textbook").drawing_wrong, 0U);
  EXPECT_EQ(RowOf(result, "kernel-exact").drawing_wrong, 0U);
}

TEST(RunFamily, MeasuresTheBaselineTwiceAndGivesItTheRatioOne) {
  const BenchResult result = RunOnce("snapped-8", {"f32-direct"});
  const BenchFamily& family = result.families.front();
  EXPECT_EQ(result.methods[family.baseline].name, kBaseline);
  EXPECT_TRUE(result.methods[family.twin].name.starts_with(kBaseline));
  EXPECT_NE(family.twin, family.baseline);
  EXPECT_EQ(RowOf(result, kBaseline).ratio, (Interval{1, 1, 1}));
  EXPECT_EQ(family.rounds, 1U);
  for (const BenchRow& row : result.rows) {
    EXPECT_EQ(row.seconds.size(), 1U);
    EXPECT_GT(row.time.median, 0);
  }
}

TEST(RunFamily, LeavesOutWhatDoesNotDrawTheFamilyAndSaysWhy) {
  const BenchResult result = RunOnce("perspective", {"f32-direct", "kernel-exact", "hom-exact"});
  EXPECT_EQ(result.methods[result.families.front().baseline].name, kClipBaseline);
  EXPECT_EQ(RowOf(result, "hom-exact").real.Wrong(), 0U);
  std::set<std::string> left_out;
  for (const BenchLeftOut& one : result.left_out) {
    left_out.insert(result.methods[one.method].name);
    EXPECT_FALSE(one.why.empty());
  }
  EXPECT_TRUE(left_out.contains("f32-direct"));
  EXPECT_TRUE(left_out.contains("kernel-exact"));
}

TEST(RunFamily, DrawsClipSpaceByItsKernel) {
  const BenchResult result =
      RunOnce("perspective",
              {"kernel-clip", "divided-exact", "divided-scanline", "spans-known", "spans-hom-f32"});
  EXPECT_EQ(RowOf(result, "kernel-clip").real.Wrong(), 0U);
  EXPECT_EQ(RowOf(result, "kernel-clip").drawing_wrong, 0U);
  EXPECT_EQ(RowOf(result, "spans-known").drawing_wrong, 0U);
  EXPECT_LT(RowOf(result, "spans-hom-f32").drawing_wrong, 100U);
  std::set<std::string> sinks;
  for (const BenchRow& row : result.rows) {
    const BenchMethod& method = result.methods[row.method];
    if (method.name == "kernel-clip") sinks.insert(method.sink);
  }
  EXPECT_EQ(sinks, (std::set<std::string>{"facing", "mask"}));
}

TEST(RunFamily, CountsWhatADivisionByWGetsWrongBehindTheEye) {
  Scene scene;
  scene.width = scene.height = 64;
  scene.precision = Precision::kFloat32;
  scene.clip_space = true;
  scene.vertices = {{5, 40, 0, 1}, {60, 40, 0, 1}, {-20, -60, 0, -1}};
  scene.triangles = {{0, 1, 2}};
  const BenchResult result = RunOnce(
      FamilyOf(scene, ""), {"kernel-clip", "divided-exact", "divided-scanline", "spans-hom-f32"});
  EXPECT_EQ(RowOf(result, "kernel-clip").drawing_wrong, 0U);
  EXPECT_LT(RowOf(result, "spans-hom-f32").drawing_wrong, 5U);
  for (const std::string_view name : {"divided-exact", "divided-scanline"}) {
    EXPECT_GT(RowOf(result, name).drawing_wrong, 100U) << name;
    EXPECT_GT(RowOf(result, name).real.Wrong(), 0U) << name;
  }
}

TEST(RunFamily, NamesTheTraitsThatClaimsAskFor) {
  std::set<std::string_view> measured;
  for (const std::string_view family : {"ties", "perspective"}) {
    const BenchResult result =
        RunOnce(family, {"kernel-exact", "kernel-exact-unsafe", "kernel-scanline",
                         "kernel-mask-rows", "kernel-tiles", "kernel-incremental",
                         "kernel-fixed-tiles", "kernel-clip", "divided-exact", "divided-scanline",
                         "f64-direct", "f32-direct", "hom-f64", "spans-known", "spans-hom-f32"});
    for (const report::Claim& claim : report::Claims()) {
      if (!report::FigureOf(claim, result).cells.empty()) measured.insert(claim.id);
    }
  }
  for (const std::string_view id : {"exactness", "floats", "full-tiles", "rows", "integers",
                                    "divided", "divided-floats", "homogeneous", "textbook-doubles",
                                    "textbook-floats", "textbook-stepping", "textbook-clip"}) {
    EXPECT_TRUE(measured.contains(id)) << id;
  }
}

TEST(OwnContenders, SayTheirTraitsAndDrawByTheTargetAskedFor) {
  const auto least = library::kernels::SupportedTargets().front();
  std::set<std::string> targets;
  for (const auto& contender : OwnContenders(ContenderChoice::kFull, least)) {
    const BenchMethod& method = contender->method();
    targets.insert(method.target);
    for (const std::string& trait : {method.traversal, method.arithmetic, method.space}) {
      EXPECT_FALSE(trait.empty()) << method.name;
    }
  }
  EXPECT_EQ(targets, (std::set<std::string>{"compiler", std::string(NameOf(least))}));
}

TEST(RunFamily, KernelsCountTheErrorsOfASnappedModelApart) {
  const BenchResult result = RunOnce("mesh", {"kernel-fixed-tiles", "i64-snap8"});
  for (const std::string_view name : {"kernel-fixed-tiles", "i64-snap8"}) {
    EXPECT_EQ(RowOf(result, name).own.Wrong(), 0U) << name;
    EXPECT_EQ(RowOf(result, name).leaks.Sum(), 0U) << name;
    EXPECT_GT(RowOf(result, name).real.Wrong(), 0U) << name;
    EXPECT_LE(RowOf(result, name).real.displacement, 0x1p-8) << name;
  }
}

TEST(RunFamily, TheRatesAreThoseOfASecondDecider) {
  // The wrong pairs of one method, found again by CGAL, sample by sample.
  const auto kinds = FamilyKinds();
  const auto kind = std::ranges::find(kinds, std::string_view("needles"), &FamilyKind::name);
  const FamilyInput family = MakeFamily(*kind, FamilySize::kQuick, 1);
  const JudgedTriangles judged(family.scene, 1);
  const auto contender = MakeMethodContender(*reference::FindMethod("f32-affine-fma"));
  contender->Load(family);
  CoverageJudge judge(family, judged);
  const BenchErrors found = judge.Of(*contender).real;
  std::uint64_t wrong = 0;
  std::vector<std::uint8_t> drawn;
  for (const std::size_t t : judged.indices()) {
    const PixelRect area = JudgedArea(family.scene, t);
    drawn.assign(
        static_cast<std::size_t>(area.x1 - area.x0) * static_cast<std::size_t>(area.y1 - area.y0),
        0);
    contender->DrawAlone(t, area, drawn);
    const auto v = Corners(family.scene, family.scene.triangles[t]);
    const std::array<Point2, 3> points{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    std::size_t at = 0;
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x, ++at) {
        // Far from the edges a second opinion costs much and says nothing.
        if (BoundaryDistance(points, CentreOf(x, y)) > 1 && drawn[at] == 0) continue;
        const bool covers = exact::Covers(points, CentreOf(x, y), {}, exact::Decider::kCgal);
        wrong += covers != (drawn[at] != 0) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(wrong, 0U);
  EXPECT_EQ(found.Wrong(), wrong);
}

TEST(RunFamily, DrawsTheLeastRoundsThoughItsTimeIsOver) {
  const auto kinds = FamilyKinds();
  const auto kind = std::ranges::find(kinds, "ties", &FamilyKind::name);
  auto contenders = OwnContenders(ContenderChoice::kQuick);
  contenders.resize(2);  // the baseline and its twin
  BenchOptions options;
  options.seconds_per_family = 0;
  options.least_rounds = 6;
  options.judged_pixels = 1;
  BenchResult result;
  RunFamily(MakeFamily(*kind, FamilySize::kQuick, 1), contenders, options, result);
  ASSERT_EQ(result.rows.size(), 2U);
  for (const BenchRow& row : result.rows) EXPECT_EQ(row.seconds.size(), 6U);
}

// A target of the family before is none of this one's.
TEST(KernelContender, DrawsAloneOnTheLoadedFamilysTarget) {
  const auto kernel = MakeKernelContender(library::kernels::SupportedTargets().front(),
                                          library::kernels::Sink::kFacing);
  for (const std::string_view name : {"fan", "walks"}) {
    const auto kinds = FamilyKinds();
    const FamilyInput family =
        MakeFamily(*std::ranges::find(kinds, name, &FamilyKind::name), FamilySize::kQuick, 1);
    kernel->Load(family);
    const PixelRect area = JudgedArea(family.scene, 0);
    std::vector<std::uint8_t> box(static_cast<std::size_t>(area.x1 - area.x0) *
                                  static_cast<std::size_t>(area.y1 - area.y0));
    kernel->DrawAlone(0, area, box);
    EXPECT_GT(std::ranges::count(box, 1), 0) << name;
  }
}

}  // namespace
}  // namespace rasterproof::bench
