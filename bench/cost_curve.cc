#include "bench/cost_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "bench/case_drawers.h"
#include "bench/family.h"
#include "bench/paired.h"
#include "bench/surface_contender.h"
#include "core/clock.h"
#include "core/profile.h"
#include "library/arguments.h"
#include "library/kernels/kernel.h"
#include "library/rasterize.h"

namespace rasterproof::bench {
namespace {

constexpr std::uint64_t kDistinct = 4096;
constexpr double kLeastDraw = 5e-4;
constexpr double kMostDraw = 1;       // seconds: what is expected to take longer is not begun
const double kLeg = std::sqrt(40.0);  // of right triangles of about 20 pixels
constexpr std::uint64_t kOfThreads = 100'000;

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
  // On 1/256 pixel, so that a float32 holds each coordinate on any target.
  const double leg = std::floor(side * 256) / 256;
  const double rise = std::floor(leg * 32) / 256;
  for (std::uint64_t k = 0; k < distinct; ++k) {
    const double x = place();
    const double y = place();
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {{x, y}, {x, y + leg}, {x + leg, y + rise}});
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

// A parameter that a triangle's cost is measured over, and into which sink.
struct Cost {
  BenchParameter parameter;
  std::string_view sink;
  Scene (*scene_of)(double value);
};

const Cost kByPixels{
    {.name = "pixels",
     .summary = "Pixels of a triangle: right triangles, scattered; 2^18 pixels a draw, or one",
     .unit = "pixels",
     .is_cost = true},
    "facing",
    &ScatteredOfPixels};
const Cost kByTriangles{
    {.name = "triangles",
     .summary = "Triangles of a draw: of 20 pixels, scattered over 1024 x 1024",
     .unit = "triangles",
     .is_cost = true},
    "facing",
    [](double count) { return ScatteredTriangles(static_cast<std::uint64_t>(count)); }};
const Cost kByTarget{
    {.name = "target",
     .summary = "Side of the target: 4096 triangles of 20 pixels, scattered over it, into masks",
     .unit = "pixels",
     .is_cost = true},
    "mask",
    [](double side) { return Scattered(kLeg, kDistinct, kDistinct, static_cast<int>(side)); }};
const BenchParameter kByThreads{
    .name = "threads",
    .summary =
        "Threads of the library, which share 100,000 triangles of 20 pixels on 1024 x 1024; "
        "elapsed time",
    .unit = "threads",
    .is_cost = true};

// Whether there is time for one more value; if there is none, the result says so.
bool IsTimeFor(const std::string& parameter, double value, const LimitOptions& options,
               BenchResult& result) {
  const std::string number = std::to_string(std::llround(value));
  if (WallSeconds() > options.end) {
    result.not_measured.push_back("costs over " + parameter + " from " + number + " on");
    return false;
  }
  if (options.progress) options.progress(parameter + ": " + number);
  return true;
}

void AddCosts(std::span<const std::unique_ptr<Contender>> contenders, const LimitOptions& options,
              const Cost& cost, const std::vector<double>& values, BenchResult& result) {
  if (!IsAsked(cost.parameter.name, options.parameters)) return;
  const std::uint32_t at = ParameterIn(result, cost.parameter);
  std::map<const Contender*, BenchCurve> curves;
  for (const double value : values) {
    if (!IsTimeFor(cost.parameter.name, value, options, result)) break;
    const CostPoint point{value, FamilyOf(cost.scene_of(value), "")};
    const auto triangles = static_cast<double>(point.family.scene.triangles.size());
    for (const auto& contender : contenders) {
      if (!IsAsked(contender->method().name, options.methods) ||
          contender->method().sink != cost.sink || contender->WhyNot(point.family)) {
        continue;
      }
      auto& points = curves[contender.get()].points;
      const bool is_slow = !points.empty() && points.back().time.median * triangles > kMostDraw;
      if (!is_slow) points.push_back(Measured(*contender, point, options.rounds));
    }
  }
  for (const auto& contender : contenders) {
    const auto found = curves.find(contender.get());
    if (found == curves.end()) continue;
    result.curves.push_back(
        {MethodIn(result, contender->method()), at, std::move(found->second.points)});
  }
}

// The library, whose threads draw one mesh together. Its time is elapsed time.
BenchMethod LibraryInto(library::kernels::Sink sink) {
  BenchMethod method;
  method.name = "library";
  method.summary = "the exact kernel by the library's own threads";
  method.kind = "exact";
  method.target = NameOf(library::kernels::SupportedTargets().back());
  method.sink = NameOf(sink);
  method.traversal = "spans";
  method.arithmetic = "exact";
  method.space = "window";
  method.model = Profile{}.name;
  method.clock = BenchClock::kWall;
  method.is_proved = true;
  method.coordinate_limit = double{std::numeric_limits<float>::max()};
  method.vertex_bytes = sizeof(library::kernels::KernelVertex);
  method.pixel_bits = BitsOf(sink);
  return method;
}

constexpr std::array<std::pair<library::kernels::Sink, RasterOutput>, 5> kOutputs{{
    {library::kernels::Sink::kCount8, RasterOutput::kCounts},
    {library::kernels::Sink::kFacing, RasterOutput::kFacingCounts},
    {library::kernels::Sink::kMask, RasterOutput::kMask},
    {library::kernels::Sink::kId, RasterOutput::kIds},
    {library::kernels::Sink::kDepth, RasterOutput::kDepths},
}};

// Memory for any output, with room after the last row.
RasterTarget TargetOf(RasterOutput output, const Scene& scene, std::vector<std::uint32_t>& memory) {
  constexpr std::size_t kRoom = 1024;
  const auto width = static_cast<std::size_t>(scene.width);
  const std::size_t words = width * static_cast<std::size_t>(scene.height) + kRoom;
  memory.resize(2 * words);
  const auto all = std::as_writable_bytes(std::span(memory));
  RasterTarget target{output, scene.width, scene.height, 0, all.first(all.size() / 2), {}};
  // Rows of masks that lay 4096 bytes apart would share a few lines of the cache.
  target.pitch = library::RowBytes(target);
  if (output == RasterOutput::kFacingCounts) target.back = all.last(all.size() / 2);
  return target;
}

void AddThreads(const LimitOptions& options, BenchResult& result) {
  if (!IsAsked(kByThreads.name, options.parameters) || !IsAsked("library", options.methods)) return;
  const FamilyInput family = FamilyOf(ScatteredTriangles(kOfThreads), "");
  const RasterMesh mesh{{&family.vertices.front().x, 3 * family.vertices.size()}, family.indices};
  const std::uint32_t at = ParameterIn(result, kByThreads);
  const auto most = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<BenchCurve> curves;
  for (const auto& [sink, output] : kOutputs) {
    curves.push_back({MethodIn(result, LibraryInto(sink)), at, {}});
  }
  std::vector<std::uint32_t> memory;
  for (int threads = 1; threads <= most; threads *= 2) {
    if (!IsTimeFor(kByThreads.name, threads, options, result)) break;
    RasterWorkers workers(threads);
    for (std::size_t k = 0; k < kOutputs.size(); ++k) {
      const RasterTarget target = TargetOf(kOutputs[k].second, family.scene, memory);
      const auto draw = [&] {
        Clear(target);
        return Timed([&] { workers.Rasterize(mesh, target); }).wall_seconds / kOfThreads;
      };
      draw();  // makes its threads' memory
      std::vector<double> seconds(4 * options.rounds);
      std::ranges::generate(seconds, draw);
      BenchPoint point;
      point.value = threads;
      point.asked = kOfThreads;
      point.time = MedianInterval(std::move(seconds));
      curves[k].points.push_back(point);
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
  return Scattered(kLeg, std::min(kDistinct, triangles), triangles, 1024);
}

void RunCostCurves(std::span<const std::unique_ptr<Contender>> contenders,
                   const LimitOptions& options, BenchResult& result) {
  AddCosts(contenders, options, kByPixels, {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}, result);
  AddCosts(contenders, options, kByTarget, {256, 512, 1024, 2048, 4096, 8192, 16384}, result);
  AddThreads(options, result);
  std::vector<double> counts;
  for (std::uint64_t count = 100; count <= options.most_triangles; count *= 10) {
    counts.push_back(static_cast<double>(count));
  }
  AddCosts(contenders, options, kByTriangles, counts, result);
}

}  // namespace rasterproof::bench
