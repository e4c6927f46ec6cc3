#include "bench/cost_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/case_drawers.h"
#include "bench/family.h"
#include "bench/paired.h"

namespace rasterproof::bench {
namespace {

constexpr std::uint64_t kDistinct = 4096;
constexpr double kLeastDraw = 5e-4;

const BenchParameter kByPixels{
    .name = "pixels",
    .summary = "Pixels of a triangle: right triangles, scattered; 2^18 pixels a draw, or one",
    .unit = "pixels",
    .is_cost = true};
const BenchParameter kByTriangles{
    .name = "triangles",
    .summary = "Triangles of a draw: of 20 pixels, scattered over 1024 x 1024",
    .unit = "triangles",
    .is_cost = true};

// `distinct` right triangles with legs of `side` pixels, then the same again up to `count`.
Scene Scattered(double side, std::uint64_t distinct, std::uint64_t count, int target) {
  Scene scene;
  scene.name = "scattered";
  scene.width = scene.height = target;
  std::mt19937_64 random(1);
  const auto place = [&] {
    const double free = std::max(0.0, target - side);
    const double at = free * static_cast<double>(random() >> 11) * 0x1p-53;
    return std::floor(at * 256 + 37) / 256;
  };
  const double leg = std::floor(side * 256) / 256;
  for (std::uint64_t k = 0; k < distinct; ++k) {
    const double x = place();
    const double y = place();
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {{x, y}, {x, y + leg}, {x + leg, y + leg / 8}});
    scene.triangles.push_back({first, first + 1, first + 2});
  }
  scene.triangles.reserve(count);
  for (std::uint64_t k = distinct; k < count; ++k) {
    scene.triangles.push_back(scene.triangles[k % distinct]);
  }
  return scene;
}

// A value, its scene in the formats that methods read, and what each contender takes for it.
struct CostPoint {
  double value;
  FamilyInput family;
};

BenchPoint Measured(Contender& contender, const CostPoint& of, std::size_t rounds) {
  contender.Load(of.family);
  const double first = contender.Draw().seconds;
  const int draws =
      std::clamp(static_cast<int>(std::ceil(kLeastDraw / std::max(first, 1e-9))), 1, 64);
  std::vector<double> seconds;
  const auto triangles = static_cast<double>(of.family.scene.triangles.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    double sum = 0;
    for (int draw = 0; draw < draws; ++draw) sum += contender.DrawTimed().seconds;
    seconds.push_back(sum / draws / triangles);
  }
  BenchPoint point;
  point.value = of.value;
  point.asked = of.family.scene.triangles.size();
  point.time = MedianInterval(std::move(seconds));
  return point;
}

void AddCosts(std::span<const std::unique_ptr<Contender>> contenders, const CurveOptions& options,
              const BenchParameter& parameter, const std::vector<double>& values,
              Scene (*scene_of)(double), BenchResult& result) {
  if (!options.parameters.empty() &&
      std::ranges::find(options.parameters, parameter.name) == options.parameters.end()) {
    return;
  }
  const std::uint32_t at = ParameterIn(result, parameter);
  std::vector<BenchCurve> curves;
  for (const double value : values) {
    if (WallSeconds() > options.end) {
      result.not_measured.push_back("costs over " + parameter.name + " from " +
                                    std::to_string(std::llround(value)) + " on");
      break;
    }
    const CostPoint point{value, FamilyOf(scene_of(value), "")};
    if (options.progress) options.progress(parameter.name + ": " + std::to_string(value));
    std::size_t k = 0;
    for (const auto& contender : contenders) {
      if (!IsAsked(*contender, options.methods) || contender->method().sink != "facing" ||
          contender->WhyNot(point.family)) {
        continue;
      }
      if (curves.size() == k) curves.push_back({MethodIn(result, contender->method()), at, {}});
      curves[k++].points.push_back(Measured(*contender, point, options.rounds));
    }
  }
  std::ranges::move(curves, std::back_inserter(result.curves));
}

}  // namespace

Scene ScatteredOfPixels(double pixels) {
  constexpr double kInAll = 0x1p18;
  const auto count = static_cast<std::uint64_t>(std::clamp(kInAll / pixels, 1.0, 4096.0));
  const double side = std::sqrt(2 * pixels);
  return Scattered(side, count, count, std::max(1024, static_cast<int>(side) + 16));
}

Scene ScatteredTriangles(std::uint64_t triangles) {
  return Scattered(std::sqrt(40.0), std::min(kDistinct, triangles), triangles, 1024);
}

void RunCostCurves(std::span<const std::unique_ptr<Contender>> contenders,
                   const CurveOptions& options, BenchResult& result) {
  AddCosts(contenders, options, kByPixels, {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}, &ScatteredOfPixels,
           result);
  std::vector<double> counts;
  for (std::uint64_t count = 100; count <= options.most_triangles; count *= 10) {
    counts.push_back(static_cast<double>(count));
  }
  AddCosts(
      contenders, options, kByTriangles, counts,
      [](double count) { return ScatteredTriangles(static_cast<std::uint64_t>(count)); }, result);
}

}  // namespace rasterproof::bench
