#include "report/bench_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "fmt/format.h"
#include "report/json_writer.h"
#include "report/limits_text.h"

namespace rasterproof::report {
namespace {

std::string_view ClockName(BenchClock clock) {
  switch (clock) {
    case BenchClock::kThread:
      return "processor";
    case BenchClock::kProgram:
      return "program";
    case BenchClock::kWall:
      return "elapsed";
  }
  return "";
}

// Rows of a family, by sink in the order of the first row of each, then by time.
std::vector<const BenchRow*> RowsOf(const BenchResult& result, std::size_t family) {
  std::vector<const BenchRow*> rows;
  std::vector<std::string_view> sinks;
  for (const BenchRow& row : result.rows) {
    if (row.family != family) continue;
    rows.push_back(&row);
    const std::string_view sink = result.methods[row.method].sink;
    if (std::ranges::find(sinks, sink) == sinks.end()) sinks.push_back(sink);
  }
  const auto place = [&](const BenchRow* row) {
    return std::ranges::find(sinks, result.methods[row->method].sink) - sinks.begin();
  };
  std::ranges::sort(rows, {}, [&](const BenchRow* row) {
    return std::tuple(place(row), row->time.median, row->method);
  });
  return rows;
}

// "proved 0", "0 of 12,345", "12.3 %": of the pairs at most a pixel from an edge.
std::string ShareText(const BenchErrors& errors, std::uint64_t of, bool is_proved) {
  if (errors.Wrong() == 0) return is_proved ? "proved 0" : fmt::format("0 of {}", of);
  return fmt::format(
      "{:.3g} %",
      of == 0 ? 0 : 100.0 * static_cast<double>(errors.Wrong()) / static_cast<double>(of));
}

std::string DistanceText(double pixels) {
  return std::isnan(pixels) ? "-" : fmt::format("{:.3g}", pixels);
}

std::string DrawingText(const BenchRow& row) {
  return row.drawing_wrong ? std::to_string(*row.drawing_wrong) : "-";
}

std::string TableOf(const BenchResult& result, std::size_t at) {
  const BenchFamily& family = result.families[at];
  std::string table = fmt::format(
      "\n{}: {}.\n  {} triangles, {} pairs covered; judged: {} triangles, {} pairs at most a pixel "
      "from an edge,\n  {} beside a shared edge; {} rounds, ratios to {}\n",
      family.name, family.summary, family.triangles, family.covered, family.judged_triangles,
      family.boundary_pairs, family.shared_pairs, family.rounds,
      result.methods.empty() ? "" : result.methods[family.baseline].name);
  table += fmt::format("  {:<28} {:<8} {:<7} {:>10} {:>22} {:>14} {:>9} {:>14} {:>6} {:>6}\n",
                       "method", "target", "sink", "ns/tri", "ratio", "wrong", "px", "own model",
                       "gaps", "over", "drawing");
  for (const BenchRow* row : RowsOf(result, at)) {
    const BenchMethod& method = result.methods[row->method];
    const std::string ratio =
        fmt::format("{:.3f} [{:.3f}, {:.3f}]", row->ratio.median, row->ratio.low, row->ratio.high);
    table += fmt::format("  {:<28} {:<8} {:<7} {:>10.1f} {:>22}", method.name, method.target,
                         method.sink, NanosecondsATriangle(result, *row), ratio);
    if (!row->is_judged) {
      table += fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n", "-", "-", "-", "-", "-",
                           DrawingText(*row));
      continue;
    }
    const bool is_real = method.model == "real";
    table +=
        fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n",
                    ShareText(row->real, family.boundary_pairs, method.is_proved && is_real),
                    DistanceText(row->real.displacement),
                    is_real ? "" : ShareText(row->own, family.boundary_pairs, method.is_proved),
                    row->leaks.gaps, row->leaks.overlaps, DrawingText(*row));
  }
  return table;
}

void WriteInterval(JsonWriter& json, std::string_view key, const Interval& interval) {
  json.Key(key).BeginArray();
  json.Rounded(interval.low).Rounded(interval.median).Rounded(interval.high);
  json.EndArray();
}

void WriteErrors(JsonWriter& json, std::string_view key, const BenchErrors& errors) {
  json.Key(key).BeginObject();
  json.Key("missing").Integer(errors.missing);
  json.Key("unexpected").Integer(errors.unexpected);
  json.Key("lost").Integer(errors.lost);
  json.Key("displacement").Rounded(errors.displacement);
  json.Key("displacement_999").Rounded(errors.displacement_999);
  if (errors.worst) {
    json.Key("worst").BeginObject();
    json.Key("triangle").Integer(errors.worst->triangle);
    json.Key("x").Integer(errors.worst->x);
    json.Key("y").Integer(errors.worst->y);
    json.EndObject();
  }
  json.EndObject();
}

void WriteMethod(JsonWriter& json, const BenchMethod& method) {
  json.BeginObject();
  json.Key("name").Text(method.name);
  json.Key("summary").Text(method.summary);
  json.Key("kind").Text(method.kind);
  json.Key("target").Text(method.target);
  json.Key("sink").Text(method.sink);
  json.Key("model").Text(method.model);
  json.Key("clock").Text(ClockName(method.clock));
  json.Key("proved").Bool(method.is_proved);
  json.Key("users").Bool(method.is_users);
  json.Key("coordinate_limit").Rounded(method.coordinate_limit);
  json.Key("vertex_bytes").Integer(method.vertex_bytes);
  json.Key("pixel_bits").Integer(method.pixel_bits);
  json.Key("conversion_seconds").Rounded(method.conversion_seconds);
  json.EndObject();
}

void WriteFamily(JsonWriter& json, const BenchResult& result, const BenchFamily& family) {
  json.BeginObject();
  json.Key("name").Text(family.name);
  json.Key("summary").Text(family.summary);
  json.Key("width").Integer(family.width);
  json.Key("height").Integer(family.height);
  json.Key("clip_space").Bool(family.is_clip_space);
  json.Key("constructed").Bool(family.is_constructed);
  json.Key("random").Bool(family.is_random);
  json.Key("largest_coordinate").Rounded(family.largest_coordinate);
  json.Key("triangles").Integer(family.triangles);
  json.Key("covered").Integer(family.covered);
  json.Key("judged_triangles").Integer(family.judged_triangles);
  json.Key("judged_covered").Integer(family.judged_covered);
  json.Key("boundary_pairs").Integer(family.boundary_pairs);
  json.Key("shared_pairs").Integer(family.shared_pairs);
  json.Key("distances").BeginArray();
  for (const std::uint64_t pairs : family.distances.pairs) json.Integer(pairs);
  json.EndArray();
  json.Key("baseline").Text(result.methods.empty() ? "" : result.methods[family.baseline].name);
  json.Key("twin").Text(result.methods.empty() ? "" : result.methods[family.twin].name);
  json.Key("rounds").Integer(family.rounds);
  json.EndObject();
}

void WriteRow(JsonWriter& json, const BenchResult& result, const BenchRow& row) {
  json.BeginObject();
  json.Key("family").Text(result.families[row.family].name);
  json.Key("method").Text(result.methods[row.method].name);
  json.Key("target").Text(result.methods[row.method].target);
  json.Key("sink").Text(result.methods[row.method].sink);
  WriteInterval(json, "seconds", row.time);
  json.Key("elapsed").Rounded(row.wall_median);
  WriteInterval(json, "ratio", row.ratio);
  json.Key("store_limit").Bool(row.binds_at_store);
  if (row.drawing_wrong) json.Key("drawing_wrong").Integer(*row.drawing_wrong);
  if (row.is_judged) {
    WriteErrors(json, "real", row.real);
    WriteErrors(json, "own", row.own);
    json.Key("gaps").Integer(row.leaks.gaps);
    json.Key("overlaps").Integer(row.leaks.overlaps);
  }
  json.Key("edge_error").Rounded(row.values.edge);
  json.Key("edge_share_of_bound").Rounded(row.values.edge_share_of_bound);
  json.Key("runs").BeginArray();
  for (const double seconds : row.seconds) json.Rounded(seconds);
  json.EndArray();
  json.EndObject();
}

}  // namespace

ErrorLane LaneOf(const BenchResult& result, const BenchRow& row) {
  if (!row.is_judged) return ErrorLane::kNotJudged;
  if (row.real.Wrong() != 0) return ErrorLane::kRate;
  const BenchMethod& method = result.methods[row.method];
  return method.is_proved && method.model == "real" ? ErrorLane::kProved : ErrorLane::kNone;
}

double NanosecondsATriangle(const BenchResult& result, const BenchRow& row) {
  const std::uint64_t triangles = result.families[row.family].triangles;
  return triangles == 0 ? 0 : 1e9 * row.time.median / static_cast<double>(triangles);
}

std::string BenchToTable(const BenchResult& result) {
  const BenchSetting& setting = result.setting;
  std::string table = fmt::format(
      "{}\n{}\nTime: median of the rounds, processor time of one draw, target cleared before it; "
      "ratio with its 95 %\ninterval, paired within rounds. Wrong: share of the pairs (triangle, "
      "sample) at most a pixel from an edge;\npx: largest distance of a wrong sample from its "
      "triangle's boundary.\n",
      setting.command, setting.processor);
  for (std::size_t at = 0; at < result.families.size(); ++at) table += TableOf(result, at);
  return table;
}

std::string BenchToJson(const BenchResult& result) {
  JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_bench").Integer(2);
  json.Key("processor").Text(result.setting.processor);
  json.Key("compiler").Text(result.setting.compiler);
  json.Key("flags").Text(result.setting.flags);
  json.Key("commit").Text(result.setting.commit);
  json.Key("command").Text(result.setting.command);
  json.Key("date").Text(result.setting.date);
  json.Key("seed").Text(std::to_string(result.setting.seed));
  json.Key("quick").Bool(result.setting.is_quick);
  json.Key("methods").BeginArray();
  for (const BenchMethod& method : result.methods) WriteMethod(json, method);
  json.EndArray();
  json.Key("families").BeginArray();
  for (const BenchFamily& family : result.families) WriteFamily(json, result, family);
  json.EndArray();
  json.Key("rows").BeginArray();
  for (const BenchRow& row : result.rows) WriteRow(json, result, row);
  json.EndArray();
  json.Key("left_out").BeginArray();
  for (const BenchLeftOut& left_out : result.left_out) {
    json.BeginObject();
    json.Key("family").Text(result.families[left_out.family].name);
    json.Key("method").Text(result.methods[left_out.method].name);
    json.Key("why").Text(left_out.why);
    json.EndObject();
  }
  json.EndArray();
  WriteLimits(json, result);
  json.EndObject();
  return json.Finish();
}

}  // namespace rasterproof::report
