#include "report/bench_json.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/scene.h"
#include "io/scene_json.h"
#include "report/bench_decision.h"
#include "report/json_writer.h"
#include "report/page_parts.h"

namespace rasterproof::report {
namespace {

constexpr int kVersion = 3;

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

void WriteInterval(JsonWriter& json, std::string_view key, const Interval& interval) {
  json.Key(key).BeginArrayLine();
  json.Rounded(interval.low).Rounded(interval.median).Rounded(interval.high);
  json.EndArray();
}

// The three members that name a method among all.
void WriteMethodKey(JsonWriter& json, const BenchResult& result, std::uint32_t index) {
  const BenchMethod& method = result.methods[index];
  json.Key("method").Text(method.name);
  json.Key("target").Text(method.target);
  json.Key("sink").Text(method.sink);
}

void WriteWitness(JsonWriter& json, const BenchWitness& witness) {
  json.Key("worst").BeginObject();
  json.Key("triangle").Integer(witness.triangle);
  json.Key("corners").BeginArray();
  for (const Vertex& corner : witness.corners) {
    json.BeginArray();
    json.Exact(corner.x).Exact(corner.y).Exact(corner.z).Exact(corner.w);
    json.EndArray();
  }
  json.EndArray();
  json.Key("x").Integer(witness.x);
  json.Key("y").Integer(witness.y);
  json.Key("distance").Shortest(witness.distance);
  json.EndObject();
}

void WriteErrors(JsonWriter& json, std::string_view key, const BenchErrors& errors) {
  json.Key(key).BeginObjectLine();
  json.Key("missing").Integer(errors.missing);
  json.Key("unexpected").Integer(errors.unexpected);
  json.Key("beside_edges").Integer(errors.beside_edges);
  json.Key("lost").Integer(errors.lost);
  json.Key("displacement").Shortest(errors.displacement);
  json.Key("displacement_999").Shortest(errors.displacement_999);
  if (errors.worst) WriteWitness(json, *errors.worst);
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
  json.Key("coordinate_limit").Shortest(method.coordinate_limit);
  json.Key("vertex_bytes").Integer(method.vertex_bytes);
  json.Key("pixel_bits").Integer(method.pixel_bits);
  json.Key("times_requests").Bool(method.times_requests);
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
  json.Key("largest_coordinate").Shortest(family.largest_coordinate);
  json.Key("triangles").Integer(family.triangles);
  json.Key("covered").Integer(family.covered);
  json.Key("judged_triangles").Integer(family.judged_triangles);
  json.Key("judged_covered").Integer(family.judged_covered);
  json.Key("boundary_pairs").Integer(family.boundary_pairs);
  json.Key("shared_pairs").Integer(family.shared_pairs);
  json.Key("distances").BeginArrayLine();
  for (const std::uint64_t pairs : family.distances.pairs) json.Integer(pairs);
  json.EndArray();
  json.Key("baseline").Text(result.methods[family.baseline].name);
  json.Key("twin").Text(result.methods[family.twin].name);
  json.Key("rounds").Integer(family.rounds);
  json.EndObject();
}

void WriteRow(JsonWriter& json, const BenchResult& result, const BenchRow& row) {
  json.BeginObjectLine();
  json.Key("family").Text(result.families[row.family].name);
  WriteMethodKey(json, result, row.method);
  WriteInterval(json, "seconds", row.time);
  json.Key("wall_seconds").Rounded(row.wall_median);
  WriteInterval(json, "ratio", row.ratio);
  json.Key("conversion_seconds").Rounded(row.conversion_seconds);
  json.Key("store_limit").Bool(row.binds_at_store);
  if (row.drawing_wrong) json.Key("drawing_wrong").Integer(*row.drawing_wrong);
  if (row.is_judged) {
    WriteErrors(json, "real", row.real);
    // Against real geometry the two are one.
    if (result.methods[row.method].model != kRealProfile) WriteErrors(json, "own", row.own);
    json.Key("judged_triangles").Integer(row.judged_triangles);
    json.Key("boundary_pairs").Integer(row.boundary_pairs);
    json.Key("gaps").Integer(row.leaks.gaps);
    json.Key("overlaps").Integer(row.leaks.overlaps);
  }
  json.Key("edge_error").Rounded(row.values.edge);
  json.Key("edge_share_of_bound").Rounded(row.values.edge_share_of_bound);
  json.Key("barycentric_error").Rounded(row.values.barycentric);
  json.Key("depth_error").Rounded(row.values.depth);
  json.Key("runs").BeginArrayLine();
  for (const double seconds : row.seconds) json.Rounded(seconds);
  json.EndArray();
  json.EndObject();
}

void WriteLeftOut(JsonWriter& json, const BenchResult& result, const BenchLeftOut& left_out) {
  json.BeginObjectLine();
  json.Key("family").Text(result.families[left_out.family].name);
  WriteMethodKey(json, result, left_out.method);
  json.Key("why").Text(left_out.why);
  json.EndObject();
}

void WriteDecision(JsonWriter& json, const BenchResult& result, std::uint32_t family, Need need) {
  const std::optional<Decision> decision = Decide(result, family, need);
  if (!decision) return;
  json.BeginObjectLine();
  json.Key("family").Text(result.families[family].name);
  json.Key("need").Text(NeedName(need));
  WriteMethodKey(json, result, decision->row->method);
  json.Key("nanoseconds_a_triangle").Rounded(NanosecondsATriangle(result, *decision->row));
  json.Key("ratio_to_fastest").Rounded(decision->ratio);
  json.Key("tied_with_fastest").Bool(decision->is_tied_with_fastest);
  json.Key("tied").BeginArrayLine();
  for (const BenchRow* row : decision->tied) json.Text(FullName(result.methods[row->method]));
  json.EndArray();
  json.EndObject();
}

// What follows from the rows, for programs to read; the parser leaves it out.
void WriteDecisions(JsonWriter& json, const BenchResult& result) {
  json.Key("decisions").BeginArray();
  for (std::uint32_t family = 0; family < result.families.size(); ++family) {
    for (const Need need : kNeeds) WriteDecision(json, result, family, need);
  }
  json.EndArray();
}

void WriteParameter(JsonWriter& json, const BenchParameter& parameter) {
  json.BeginObject();
  json.Key("name").Text(parameter.name);
  json.Key("summary").Text(parameter.summary);
  json.Key("unit").Text(parameter.unit);
  json.Key("cost").Bool(parameter.is_cost);
  json.EndObject();
}

// Errors, or costs: [value, asked, wrong, displacement, share of the bound], or [value, asked, low,
// median, high] of the seconds.
void WritePoint(JsonWriter& json, const BenchPoint& point, bool is_cost) {
  json.BeginArrayLine();
  json.Shortest(point.value).Integer(point.asked);
  if (is_cost) {
    json.Rounded(point.time.low).Rounded(point.time.median).Rounded(point.time.high);
  } else {
    json.Integer(point.wrong).Rounded(point.displacement).Rounded(point.share_of_bound);
  }
  json.EndArray();
}

void WriteCurve(JsonWriter& json, const BenchResult& result, const BenchCurve& curve) {
  const BenchParameter& parameter = result.parameters[curve.parameter];
  json.BeginObjectLine();
  WriteMethodKey(json, result, curve.method);
  json.Key("parameter").Text(parameter.name);
  json.Key("points").BeginArray();
  for (const BenchPoint& point : curve.points) WritePoint(json, point, parameter.is_cost);
  json.EndArray();
  json.EndObject();
}

void WriteCliff(JsonWriter& json, const BenchResult& result, const BenchCliff& cliff) {
  json.BeginObjectLine();
  WriteMethodKey(json, result, cliff.method);
  json.Key("parameter").Text(result.parameters[cliff.parameter].name);
  json.Key("proved_to").Shortest(cliff.proved_to);
  json.Key("held_to").Shortest(cliff.held_to);
  json.Key("first_failing").Shortest(cliff.first_failing);
  if (cliff.scene) {
    std::string scene;
    io::AppendSceneJson(*cliff.scene, "", scene);
    std::erase(scene, '\n');
    json.Key("scene").Value(scene);
    json.Key("x").Integer(cliff.x);
    json.Key("y").Integer(cliff.y);
  }
  json.EndObject();
}

void WriteStage(JsonWriter& json, const BenchStage& stage) {
  json.BeginObject();
  json.Key("name").Text(stage.name);
  json.Key("summary").Text(stage.summary);
  json.Key("wrong").Integer(stage.wrong);
  json.Key("asked").Integer(stage.asked);
  json.Key("displacement").Shortest(stage.displacement);
  json.EndObject();
}

void WriteFingerprint(JsonWriter& json, const BenchResult& result, const BenchFingerprint& print) {
  json.BeginObject();
  WriteMethodKey(json, result, print.method);
  json.Key("step").Text(print.step);
  json.Key("wrong").Integer(print.wrong);
  json.Key("png").Text(print.png);
  json.Key("places").Integer(print.places);
  json.EndObject();
}

void WriteSetting(JsonWriter& json, const BenchSetting& setting) {
  json.Key("rasterproof_bench").Integer(kVersion);
  json.Key("processor").Text(setting.processor);
  json.Key("compiler").Text(setting.compiler);
  json.Key("flags").Text(setting.flags);
  json.Key("commit").Text(setting.commit);
  json.Key("command").Text(setting.command);
  json.Key("date").Text(setting.date);
  json.Key("seed").Text(std::to_string(setting.seed));
  json.Key("quick").Bool(setting.is_quick);
}

template <class Items, class Write>
void WriteArray(JsonWriter& json, std::string_view key, const Items& items, Write write) {
  json.Key(key).BeginArray();
  for (const auto& item : items) write(item);
  json.EndArray();
}

}  // namespace

std::string BenchToJson(const BenchResult& result) {
  JsonWriter json;
  // Writes an item that names a method or a family by its place in the result.
  const auto in_result = [&](auto write) {
    return [&json, &result, write](const auto& item) { write(json, result, item); };
  };
  const auto alone = [&](auto write) {
    return [&json, write](const auto& item) { write(json, item); };
  };
  json.BeginObject();
  WriteSetting(json, result.setting);
  WriteArray(json, "methods", result.methods, alone(WriteMethod));
  WriteArray(json, "families", result.families, in_result(WriteFamily));
  WriteArray(json, "rows", result.rows, in_result(WriteRow));
  WriteArray(json, "left_out", result.left_out, in_result(WriteLeftOut));
  WriteDecisions(json, result);
  WriteArray(json, "parameters", result.parameters, alone(WriteParameter));
  WriteArray(json, "curves", result.curves, in_result(WriteCurve));
  WriteArray(json, "cliffs", result.cliffs, in_result(WriteCliff));
  WriteArray(json, "stages", result.stages, alone(WriteStage));
  WriteArray(json, "fingerprints", result.fingerprints, in_result(WriteFingerprint));
  json.EndObject();
  return json.Finish();
}

}  // namespace rasterproof::report
