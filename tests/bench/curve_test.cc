#include "bench/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cost_curve.h"
#include "bench/parameter.h"
#include "core/ulp.h"
#include "library/kernels/kernel.h"
#include "reference/method.h"
#include "tests/share.h"

namespace rasterproof::bench {
namespace {

std::vector<BenchPoint> CurveOf(std::string_view method, std::string_view parameter) {
  const auto contender = MakeMethodContender(*reference::FindMethod(method));
  JudgedCases cases;
  return ErrorCurve(*DrawerOf(*contender), *FindParameter(parameter), cases);
}

const BenchPoint& At(const std::vector<BenchPoint>& points, double value) {
  return *std::ranges::find(points, value, &BenchPoint::value);
}

TEST(Parameters, HaveCasesThatAreTheSameEveryTime) {
  for (const Parameter& parameter : Parameters()) {
    std::size_t all = 0;
    for (int k = parameter.least_exponent; k <= parameter.most_exponent; ++k) {
      const double value = std::ldexp(1.0, k);
      const auto cases = parameter.hardest(value);
      const auto again = parameter.hardest(value);
      ASSERT_EQ(cases.size(), again.size()) << parameter.name << " " << value;
      all += cases.size();
      for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_EQ(cases[i].scene, again[i].scene) << parameter.name << " " << value;
        EXPECT_LT(cases[i].x, cases[i].scene.width);
        EXPECT_LT(cases[i].y, cases[i].scene.height);
        if (cases[i].scene.precision == Precision::kFloat64) continue;
        for (const Vertex& v : cases[i].scene.vertices) {
          EXPECT_TRUE(IsFloat32(v.x) && IsFloat32(v.y) && IsFloat32(v.w)) << parameter.name;
        }
      }
    }
    EXPECT_GT(all, 100U) << parameter.name;
  }
}

/// All parameters; under sanitizers the first one.
std::span<const Parameter> SomeParameters() {
  return kOneCaseIn > 1 ? Parameters().first(1) : Parameters();
}

TEST(ErrorCurve, OfAnExactMethodIsZero) {
  for (const Parameter& parameter : SomeParameters()) {
    for (const BenchPoint& point : CurveOf("spans-exact", parameter.name)) {
      EXPECT_EQ(point.wrong, 0U) << parameter.name << " " << point.value;
    }
  }
  for (const BenchPoint& point : CurveOf("hom-exact", "w")) EXPECT_EQ(point.wrong, 0U);
}

TEST(ErrorCurve, StaysWithinTheProvenBounds) {
  for (const std::string_view method : {"f32-direct", "f32-kahan", "f32-affine", "f64-direct"}) {
    for (const Parameter& parameter : SomeParameters()) {
      for (const BenchPoint& point : CurveOf(method, parameter.name)) {
        EXPECT_FALSE(point.share_of_bound > 1)
            << method << " " << parameter.name << " " << point.value;
      }
    }
  }
}

TEST(ErrorCurve, OfIncrementsGrowsWithTheSquareOfTheSteps) {
  const auto points = CurveOf("f32-incremental", "steps");
  // The largest known drift is n^2 2^-26 pixels: 4 pixels after 16384 steps.
  EXPECT_GT(At(points, 16384).displacement, 1);
  EXPECT_LE(At(points, 16384).displacement, 4);
  EXPECT_GT(At(points, 1024).displacement, 1.0 / 256);
  EXPECT_LE(At(points, 1024).displacement, 1.0 / 64);
  EXPECT_LT(At(CurveOf("f32-direct", "steps"), 16384).displacement, 0.01);
}

TEST(ErrorCurve, OfTheDirectFormIsZeroWhereLittleCancels) {
  const auto points = CurveOf("f32-direct", "cancellation");
  // No sign is wrong where |E| > 3 u S.
  for (const BenchPoint& point : points) {
    EXPECT_TRUE(point.value > 0x1p21 || point.wrong == 0) << point.value;
  }
  EXPECT_GT(At(points, 0x1p43).wrong, 0U);
}

TEST(RunCostCurves, MeasuresCostsOfWhatCountsByFacing) {
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(MakeMethodContender(*reference::FindMethod("f32-direct")));
  LimitOptions options;
  options.parameters = {"pixels", "triangles"};
  options.most_triangles = 1000;
  options.rounds = 3;
  BenchResult result;
  RunCostCurves(contenders, options, result);
  ASSERT_EQ(result.curves.size(), 2U);
  EXPECT_EQ(result.parameters[result.curves[0].parameter].name, "pixels");
  EXPECT_TRUE(result.parameters[result.curves[0].parameter].is_cost);
  EXPECT_EQ(result.curves[0].points.size(), 7U);
  EXPECT_EQ(result.curves[1].points.size(), 2U);
  for (const BenchCurve& curve : result.curves) {
    for (const BenchPoint& point : curve.points) EXPECT_GT(point.time.median, 0);
  }
}

const BenchParameter& ParameterOf(const BenchResult& result, const BenchCurve& curve) {
  return result.parameters[curve.parameter];
}

TEST(RunCostCurves, MeasuresMasksOverTheTargetAndTheLibraryOverThreads) {
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const auto sink : {library::kernels::Sink::kMask, library::kernels::Sink::kFacing}) {
    contenders.push_back(MakeKernelContender(library::kernels::Target::kScalar, sink));
  }
  LimitOptions options;
  options.parameters = {"target", "threads"};
  options.rounds = 1;
  BenchResult result;
  RunCostCurves(contenders, options, result);
  ASSERT_EQ(result.curves.size(), 1 + library::kernels::kSinks.size());
  EXPECT_EQ(ParameterOf(result, result.curves[0]).name, "target");
  EXPECT_EQ(result.methods[result.curves[0].method].sink, "mask");
  EXPECT_EQ(result.curves[0].points.front().value, 256);
  EXPECT_EQ(result.curves[0].points.back().value, 16384);
  std::set<std::string> sinks;
  for (const BenchCurve& curve : std::span(result.curves).subspan(1)) {
    EXPECT_EQ(ParameterOf(result, curve).name, "threads");
    EXPECT_EQ(result.methods[curve.method].name, "library");
    sinks.insert(result.methods[curve.method].sink);
    ASSERT_GE(curve.points.size(), 2U);
    EXPECT_EQ(curve.points[1].value, 2);
    for (const BenchPoint& point : curve.points) EXPECT_GT(point.time.median, 0);
  }
  EXPECT_EQ(sinks.size(), library::kernels::kSinks.size());
}

// A draw of it is said to take half a second.
class Slow final : public Contender {
 public:
  Slow() { method_.name = "slow", method_.sink = "facing"; }
  std::optional<std::string> WhyNot(const FamilyInput&) const override { return std::nullopt; }
  void Load(const FamilyInput& family) override { triangles_ = family.scene.triangles.size(); }
  DrawTime Draw() override {
    const double seconds = 5e-3 * static_cast<double>(triangles_);
    return {.seconds = seconds, .wall_seconds = seconds};
  }
  bool MoveDrawn(CoverageCounts&) override { return false; }
  void DrawAlone(std::size_t, const PixelRect&, std::vector<std::uint8_t>&) override {}
  std::uint64_t LeftBehind() override { return 0; }

 private:
  std::size_t triangles_ = 0;
};

TEST(RunCostCurves, BeginNoDrawThatWouldTakeLong) {
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(std::make_unique<Slow>());
  LimitOptions options;
  options.parameters = {"triangles"};
  BenchResult result;
  RunCostCurves(contenders, options, result);
  ASSERT_EQ(result.curves.size(), 1U);
  EXPECT_EQ(result.curves[0].points.size(), 1U);
  EXPECT_NEAR(result.curves[0].points[0].time.median, 5e-3, 1e-9);
}

TEST(ScatteredTriangles, AreAsManyAsAskedFor) {
  EXPECT_EQ(ScatteredTriangles(100).triangles.size(), 100U);
  EXPECT_EQ(ScatteredTriangles(10'000).triangles.size(), 10'000U);
  EXPECT_EQ(ScatteredOfPixels(1e6).triangles.size(), 1U);
}

}  // namespace
}  // namespace rasterproof::bench
