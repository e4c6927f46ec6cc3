#include "io/bench_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quoted.h"
#include "io/json_members.h"
#include "io/output.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr int kBenchVersion = 3;

constexpr auto kFileKeys = std::to_array<std::string_view>(
    {"rasterproof_bench", "processor", "compiler", "flags", "commit", "command", "date", "seed",
     "quick", "methods", "families", "rows", "left_out", "decisions", "parameters", "curves",
     "cliffs", "stages", "fingerprints"});
constexpr auto kMethodKeys = std::to_array<std::string_view>(
    {"name", "summary", "kind", "target", "sink", "model", "clock", "proved", "users",
     "coordinate_limit", "vertex_bytes", "pixel_bits", "times_requests"});
constexpr auto kFamilyKeys = std::to_array<std::string_view>(
    {"name", "summary", "width", "height", "clip_space", "constructed", "random",
     "largest_coordinate", "triangles", "covered", "judged_triangles", "judged_covered",
     "boundary_pairs", "shared_pairs", "distances", "baseline", "twin", "rounds"});
constexpr auto kRowKeys = std::to_array<std::string_view>({"family",
                                                           "method",
                                                           "target",
                                                           "sink",
                                                           "seconds",
                                                           "wall_seconds",
                                                           "ratio",
                                                           "conversion_seconds",
                                                           "store_limit",
                                                           "drawing_wrong",
                                                           "real",
                                                           "own",
                                                           "judged_triangles",
                                                           "boundary_pairs",
                                                           "gaps",
                                                           "overlaps",
                                                           "edge_error",
                                                           "edge_share_of_bound",
                                                           "barycentric_error",
                                                           "depth_error",
                                                           "runs"});
constexpr auto kErrorKeys = std::to_array<std::string_view>(
    {"missing", "unexpected", "beside_edges", "lost", "displacement", "displacement_999", "worst"});
constexpr auto kWitnessKeys =
    std::to_array<std::string_view>({"triangle", "corners", "x", "y", "distance"});
constexpr auto kLeftOutKeys =
    std::to_array<std::string_view>({"family", "method", "target", "sink", "why"});
constexpr auto kParameterKeys =
    std::to_array<std::string_view>({"name", "summary", "unit", "cost"});
constexpr auto kCurveKeys =
    std::to_array<std::string_view>({"method", "target", "sink", "parameter", "points"});
constexpr auto kCliffKeys =
    std::to_array<std::string_view>({"method", "target", "sink", "parameter", "proved_to",
                                     "held_to", "first_failing", "scene", "x", "y"});
constexpr auto kStageKeys =
    std::to_array<std::string_view>({"name", "summary", "wrong", "asked", "displacement"});
constexpr auto kFingerprintKeys =
    std::to_array<std::string_view>({"method", "target", "sink", "step", "wrong", "png", "places"});

constexpr std::array<std::pair<BenchClock, std::string_view>, 3> kClocks{
    {{BenchClock::kThread, "processor"},
     {BenchClock::kProgram, "program"},
     {BenchClock::kWall, "elapsed"}}};

std::string String(const JsonValue& value) { return std::string(value.RequireString()); }

double Double(const JsonValue& value) { return CoordinateFromJson(value, Precision::kFloat64); }

std::uint64_t Count(const JsonValue& value) {
  return static_cast<std::uint64_t>(value.RequireInteger(0, INT64_MAX));
}

std::string String(const JsonValue& object, std::string_view key) {
  return String(object.Get(key));
}

double Double(const JsonValue& object, std::string_view key) { return Double(object.Get(key)); }

std::uint64_t Count(const JsonValue& object, std::string_view key) {
  return Count(object.Get(key));
}

int Pixel(const JsonValue& object, std::string_view key) {
  return Integer(object.Get(key), INT32_MIN, INT32_MAX);
}

// The items of an array that has exactly `n`.
std::vector<JsonValue> Several(const JsonValue& value, std::size_t n) {
  std::vector<JsonValue> items;
  for (const JsonValue item : value.RequireArray()) items.push_back(item);
  if (items.size() == n) return items;
  throw value.Error("has " + std::to_string(items.size()) + " items",
                    "write " + std::to_string(n) + " of them");
}

Interval IntervalOf(const JsonValue& value) {
  const std::vector<JsonValue> items = Several(value, 3);
  return {Double(items[0]), Double(items[1]), Double(items[2])};
}

template <class T, class Read>
void ReadList(const JsonValue& object, std::string_view key, std::vector<T>& into, Read read) {
  for (const JsonValue item : object.Get(key).RequireArray()) into.push_back(read(item));
}

// The place among `list` of the one of this name.
template <class T>
std::uint32_t IndexOf(const JsonValue& name, const std::vector<T>& list, std::string_view what) {
  const std::string_view text = name.RequireString();
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (list[k].name == text) return static_cast<std::uint32_t>(k);
  }
  throw name.Error(Quoted(text) + " is no " + std::string(what) + " of this file",
                   "write the name of one that it lists");
}

// The method that three members name.
std::uint32_t MethodOf(const JsonValue& object, const BenchResult& result) {
  const std::string name = String(object, "method");
  const std::string target = String(object, "target");
  const std::string sink = String(object, "sink");
  for (std::size_t k = 0; k < result.methods.size(); ++k) {
    const BenchMethod& method = result.methods[k];
    if (method.name == name && method.target == target && method.sink == sink) {
      return static_cast<std::uint32_t>(k);
    }
  }
  throw object.Get("method").Error(
      Quoted(name) + " by " + Quoted(target) + " into " + Quoted(sink) +
          " is no method of this file",
      "write \"method\", \"target\" and \"sink\" of one that it lists");
}

BenchMethod MethodFromJson(const JsonValue& value) {
  value.RequireObject(kMethodKeys);
  BenchMethod method;
  method.name = String(value, "name");
  method.summary = String(value, "summary");
  method.kind = String(value, "kind");
  method.target = String(value, "target");
  method.sink = String(value, "sink");
  method.model = String(value, "model");
  method.clock = FromName(value.Get("clock"), Names<BenchClock>(kClocks));
  method.is_proved = Boolean(value.Get("proved"));
  method.is_users = Boolean(value.Get("users"));
  method.coordinate_limit = Double(value, "coordinate_limit");
  method.vertex_bytes = Count(value, "vertex_bytes");
  method.pixel_bits = Count(value, "pixel_bits");
  method.times_requests = Boolean(value.Get("times_requests"));
  return method;
}

BenchFamily FamilyFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kFamilyKeys);
  BenchFamily family;
  family.name = String(value, "name");
  family.summary = String(value, "summary");
  family.width = Integer(value.Get("width"), 1, kMaxTargetSide);
  family.height = Integer(value.Get("height"), 1, kMaxTargetSide);
  family.is_clip_space = Boolean(value.Get("clip_space"));
  family.is_constructed = Boolean(value.Get("constructed"));
  family.is_random = Boolean(value.Get("random"));
  family.largest_coordinate = Double(value, "largest_coordinate");
  family.triangles = Count(value, "triangles");
  family.covered = Count(value, "covered");
  family.judged_triangles = Count(value, "judged_triangles");
  family.judged_covered = Count(value, "judged_covered");
  family.boundary_pairs = Count(value, "boundary_pairs");
  family.shared_pairs = Count(value, "shared_pairs");
  std::size_t k = 0;
  for (const JsonValue item : Several(value.Get("distances"), family.distances.pairs.size())) {
    family.distances.pairs[k++] = Count(item);
  }
  family.baseline = IndexOf(value.Get("baseline"), result.methods, "method");
  family.twin = IndexOf(value.Get("twin"), result.methods, "method");
  family.rounds = Count(value, "rounds");
  return family;
}

BenchWitness WitnessFromJson(const JsonValue& value) {
  value.RequireObject(kWitnessKeys);
  BenchWitness witness;
  witness.triangle = Count(value, "triangle");
  const std::vector<JsonValue> corners = Several(value.Get("corners"), witness.corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::vector<JsonValue> xyzw = Several(corners[k], 4);
    witness.corners[k] = {Double(xyzw[0]), Double(xyzw[1]), Double(xyzw[2]), Double(xyzw[3])};
  }
  witness.x = Pixel(value, "x");
  witness.y = Pixel(value, "y");
  witness.distance = Double(value, "distance");
  return witness;
}

BenchErrors ErrorsFromJson(const JsonValue& value) {
  value.RequireObject(kErrorKeys);
  BenchErrors errors;
  errors.missing = Count(value, "missing");
  errors.unexpected = Count(value, "unexpected");
  errors.beside_edges = Count(value, "beside_edges");
  errors.lost = Count(value, "lost");
  errors.displacement = Double(value, "displacement");
  errors.displacement_999 = Double(value, "displacement_999");
  ReadIfThere(value, "worst", errors.worst, WitnessFromJson);
  return errors;
}

BenchRow RowFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kRowKeys);
  BenchRow row;
  row.family = IndexOf(value.Get("family"), result.families, "family");
  row.method = MethodOf(value, result);
  row.time = IntervalOf(value.Get("seconds"));
  row.wall_median = Double(value, "wall_seconds");
  row.conversion_seconds = Double(value, "conversion_seconds");
  row.ratio = IntervalOf(value.Get("ratio"));
  row.binds_at_store = Boolean(value.Get("store_limit"));
  ReadIfThere(value, "drawing_wrong", row.drawing_wrong,
              [](const JsonValue& v) { return Count(v); });
  row.is_judged = value.Find("real").has_value();
  if (row.is_judged) {
    row.real = ErrorsFromJson(value.Get("real"));
    row.own = row.real;
    if (const auto own = value.Find("own")) row.own = ErrorsFromJson(*own);
    row.judged_triangles = Count(value, "judged_triangles");
    row.boundary_pairs = Count(value, "boundary_pairs");
    row.leaks = {Count(value, "gaps"), Count(value, "overlaps")};
  }
  row.values.edge = Double(value, "edge_error");
  row.values.edge_share_of_bound = Double(value, "edge_share_of_bound");
  row.values.barycentric = Double(value, "barycentric_error");
  row.values.depth = Double(value, "depth_error");
  ReadList(value, "runs", row.seconds, [](const JsonValue& v) { return Double(v); });
  return row;
}

BenchLeftOut LeftOutFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kLeftOutKeys);
  return {IndexOf(value.Get("family"), result.families, "family"), MethodOf(value, result),
          String(value, "why")};
}

BenchParameter ParameterFromJson(const JsonValue& value) {
  value.RequireObject(kParameterKeys);
  return {String(value, "name"), String(value, "summary"), String(value, "unit"),
          Boolean(value.Get("cost"))};
}

// Errors: [value, asked, wrong, displacement, share of the bound].
// Costs: [value, asked, low, median, high], seconds.
BenchPoint PointFromJson(const JsonValue& value, bool is_cost) {
  const std::vector<JsonValue> items = Several(value, 5);
  BenchPoint point;
  point.value = Double(items[0]);
  point.asked = Count(items[1]);
  if (is_cost) {
    point.time = {Double(items[2]), Double(items[3]), Double(items[4])};
    return point;
  }
  point.wrong = Count(items[2]);
  point.displacement = Double(items[3]);
  point.share_of_bound = Double(items[4]);
  return point;
}

BenchCurve CurveFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kCurveKeys);
  BenchCurve curve;
  curve.method = MethodOf(value, result);
  curve.parameter = IndexOf(value.Get("parameter"), result.parameters, "parameter");
  const bool is_cost = result.parameters[curve.parameter].is_cost;
  ReadList(value, "points", curve.points,
           [&](const JsonValue& point) { return PointFromJson(point, is_cost); });
  return curve;
}

BenchCliff CliffFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kCliffKeys);
  BenchCliff cliff;
  cliff.method = MethodOf(value, result);
  cliff.parameter = IndexOf(value.Get("parameter"), result.parameters, "parameter");
  cliff.proved_to = Double(value, "proved_to");
  cliff.held_to = Double(value, "held_to");
  cliff.first_failing = Double(value, "first_failing");
  if (const std::optional<JsonValue> scene = value.Find("scene")) {
    cliff.scene = SceneFromJson(*scene);
    cliff.x = Pixel(value, "x");
    cliff.y = Pixel(value, "y");
  }
  return cliff;
}

BenchStage StageFromJson(const JsonValue& value) {
  value.RequireObject(kStageKeys);
  return {String(value, "name"), String(value, "summary"), Count(value, "wrong"),
          Count(value, "asked"), Double(value, "displacement")};
}

BenchFingerprint FingerprintFromJson(const JsonValue& value, const BenchResult& result) {
  value.RequireObject(kFingerprintKeys);
  return {MethodOf(value, result), String(value, "step"), Count(value, "wrong"),
          String(value, "png"), Count(value, "places")};
}

std::uint64_t Seed(const JsonValue& value) {
  const std::string_view text = value.RequireString();
  std::uint64_t seed = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (fault == std::errc() && end == text.data() + text.size()) return seed;
  throw value.Error(Quoted(text) + " is no seed", "write an integer below 2^64 as a string");
}

void RequireBench(const JsonValue& object) {
  if (object.kind() == JsonKind::kObject && !object.Find("rasterproof_bench")) {
    throw object.Error("is no bench file: the key \"rasterproof_bench\" is missing",
                       "give a file that rasterproof bench --json wrote");
  }
  // Keys differ from version to version, so that a version is asked for first.
  const JsonValue version = object.Get("rasterproof_bench");
  if (version.RequireInteger(0, INT32_MAX) != kBenchVersion) {
    throw version.Error("version " + std::string(version.text()) + " is unknown",
                        "this program reads version 3: measure again by rasterproof bench --json");
  }
  object.RequireObject(kFileKeys);
}

BenchSetting SettingFromJson(const JsonValue& object) {
  BenchSetting setting;
  setting.processor = String(object, "processor");
  setting.compiler = String(object, "compiler");
  setting.flags = String(object, "flags");
  setting.commit = String(object, "commit");
  setting.command = String(object, "command");
  setting.date = String(object, "date");
  setting.seed = Seed(object.Get("seed"));
  setting.is_quick = Boolean(object.Get("quick"));
  return setting;
}

}  // namespace

BenchResult ParseBench(std::string_view text, const std::string& place) {
  const JsonDocument document(text, place);
  const JsonValue root = document.root();
  RequireBench(root);
  BenchResult result;
  // Reads an item that names others of the file, which are read before it.
  const auto in_result = [&](auto read) {
    return [&result, read](const JsonValue& value) { return read(value, result); };
  };
  result.setting = SettingFromJson(root);
  ReadList(root, "methods", result.methods, MethodFromJson);
  ReadList(root, "families", result.families, in_result(FamilyFromJson));
  ReadList(root, "rows", result.rows, in_result(RowFromJson));
  ReadList(root, "left_out", result.left_out, in_result(LeftOutFromJson));
  ReadList(root, "parameters", result.parameters, ParameterFromJson);
  ReadList(root, "curves", result.curves, in_result(CurveFromJson));
  ReadList(root, "cliffs", result.cliffs, in_result(CliffFromJson));
  ReadList(root, "stages", result.stages, StageFromJson);
  ReadList(root, "fingerprints", result.fingerprints, in_result(FingerprintFromJson));
  return result;
}

BenchResult ReadBench(const std::string& path) {
  return ParseBench(ReadFile(path), path == "-" ? "standard input" : path);
}

}  // namespace rasterproof::io
