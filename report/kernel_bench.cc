#include "report/kernel_bench.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/kernel_bench_result.h"
#include "fmt/format.h"
#include "report/json_writer.h"

namespace rasterproof::report {
namespace {

double Nanoseconds(double seconds, std::uint64_t over) {
  return over == 0 ? 0 : 1e9 * seconds / static_cast<double>(over);
}

std::uint64_t PixelsOf(const KernelBenchResult& result) {
  return static_cast<std::uint64_t>(result.width) * static_cast<std::uint64_t>(result.height);
}

// The share of the store limit that a row reaches: the limit's time a pixel over the row's.
double ShareOfLimit(const KernelBenchResult& result, const KernelBenchScene& scene,
                    const KernelBenchRow& row) {
  const auto limit = std::ranges::find_if(result.limits, [&](const KernelBenchLimit& l) {
    return l.sink == row.sink && l.target == row.target;
  });
  const double pixel = Nanoseconds(row.times.least, scene.covered);
  if (limit == result.limits.end() || pixel == 0) return 0;
  return Nanoseconds(limit->times.least, PixelsOf(result)) / pixel;
}

const KernelBenchScene& SceneOf(const KernelBenchResult& result, const KernelBenchRow& row) {
  return *std::ranges::find(result.scenes, row.scene, &KernelBenchScene::name);
}

void WriteTimes(JsonWriter& json, const Times& times, std::uint64_t over, std::string_view unit) {
  const auto write = [&](std::string_view what, double seconds) {
    json.Key(fmt::format("{}_ns_per_{}", what, unit)).Rounded(Nanoseconds(seconds, over));
  };
  write("median", times.median);
  write("least", times.least);
  write("spread", times.spread);
}

}  // namespace

std::string KernelBenchToTable(const KernelBenchResult& result) {
  std::string table = fmt::format(
      "{} x {}, one thread. Nanoseconds of thread CPU time a triangle: median, least and the "
      "spread "
      "of the\nmiddle half of {} interleaved draws; least a covered pixel; its share of the store "
      "limit. Only ratios\nwithin one run mean something.\n",
      result.width, result.height, result.repetitions);
  table += fmt::format("\nStore limits: one pass over the target\n  {:<8} {:<8} {:>12} {:>12}\n",
                       "sink", "target", "median ns/px", "Gpx/s");
  for (const KernelBenchLimit& limit : result.limits) {
    const double median = Nanoseconds(limit.times.median, PixelsOf(result));
    const double least = Nanoseconds(limit.times.least, PixelsOf(result));
    table += fmt::format("  {:<8} {:<8} {:>12.4f} {:>12.1f}\n", limit.sink, limit.target, median,
                         least > 0 ? 1 / least : 0);
  }
  std::string_view scene_name;
  for (const KernelBenchRow& row : result.rows) {
    const KernelBenchScene& scene = SceneOf(result, row);
    if (scene.name != scene_name) {
      scene_name = scene.name;
      table += fmt::format("\n{}: {}; {} triangles, {:.2f} px each\n", scene.name, scene.summary,
                           scene.triangles,
                           static_cast<double>(scene.covered) /
                               static_cast<double>(std::max<std::uint64_t>(scene.triangles, 1)));
      table +=
          fmt::format("  {:<8} {:<12} {:<8} {:>11} {:>11} {:>9} {:>9} {:>7} {:>9}\n", "sink",
                      "method", "target", "median", "least", "spread", "ns/px", "limit", "wrong");
    }
    table += fmt::format(
        "  {:<8} {:<12} {:<8} {:>11.1f} {:>11.1f} {:>9.1f} {:>9.3f} {:>6.0f}% {:>9}\n", row.sink,
        row.method, row.target, Nanoseconds(row.times.median, scene.triangles),
        Nanoseconds(row.times.least, scene.triangles),
        Nanoseconds(row.times.spread, scene.triangles), Nanoseconds(row.times.least, scene.covered),
        100 * ShareOfLimit(result, scene, row), row.wrong);
  }
  return table;
}

std::string KernelBenchToJson(const KernelBenchResult& result) {
  JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_kernel_bench").Integer(1);
  json.Key("width").Integer(result.width);
  json.Key("height").Integer(result.height);
  json.Key("repetitions").Integer(result.repetitions);
  json.Key("seed").Text(std::to_string(result.seed));
  json.Key("limits").BeginArray();
  for (const KernelBenchLimit& limit : result.limits) {
    json.BeginObject();
    json.Key("sink").Text(limit.sink);
    json.Key("target").Text(limit.target);
    WriteTimes(json, limit.times, PixelsOf(result), "pixel");
    json.EndObject();
  }
  json.EndArray();
  json.Key("scenes").BeginArray();
  for (const KernelBenchScene& scene : result.scenes) {
    json.BeginObject();
    json.Key("name").Text(scene.name);
    json.Key("triangles").Integer(scene.triangles);
    json.Key("covered").Integer(scene.covered);
    json.EndObject();
  }
  json.EndArray();
  json.Key("rows").BeginArray();
  for (const KernelBenchRow& row : result.rows) {
    json.BeginObject();
    json.Key("scene").Text(row.scene);
    json.Key("sink").Text(row.sink);
    json.Key("method").Text(row.method);
    json.Key("target").Text(row.target);
    WriteTimes(json, row.times, SceneOf(result, row).triangles, "triangle");
    json.Key("wrong").Integer(row.wrong);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  return json.Finish();
}

}  // namespace rasterproof::report
