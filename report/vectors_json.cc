#include "report/vectors_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/channel.h"
#include "core/hash_text.h"
#include "core/sample_rows.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/json_writer.h"
#include "io/profile_json.h"

namespace rasterproof::report {
namespace {

void AddTexts(io::JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
  json.Key(key).BeginArray();
  for (const std::string& text : texts) json.Text(text);
  json.EndArray();
}

template <class Names, class Value>
std::string_view NameIn(const Names& names, Value value) {
  return std::ranges::find(names, value, &Names::value_type::first)->second;
}

template <class Numbers>
void AddNumbers(io::JsonWriter& json, std::string_view key, const Numbers& numbers) {
  json.Key(key).BeginArray();
  for (const auto number : numbers) json.Integer(number);
  json.EndArray();
}

std::string_view AxisWord(YAxis axis) { return axis == YAxis::kUp ? "up" : "down"; }

// [x, y] in units of 2^-8 pixels, which every sample location is on.
void AddPattern(io::JsonWriter& json, const SamplePattern& pattern) {
  json.Key("samples_256").BeginArray();
  for (const Point2& at : pattern.locations) {
    json.BeginArray().Integer(std::lround(at.x * 256)).Integer(std::lround(at.y * 256)).EndArray();
  }
  json.EndArray();
}

void AddVertices(io::JsonWriter& json, const TestVector& vector) {
  json.Key("vertices").BeginArray();
  for (const Vertex& v : vector.scene.vertices) json.BeginArray().Exact(v.x).Exact(v.y).EndArray();
  json.EndArray();
  json.Key("fixed");
  if (!vector.on_lattice) {
    json.Null();
    return;
  }
  json.BeginArray();
  for (const auto& [x, y] : *vector.on_lattice) json.BeginArray().Integer(x).Integer(y).EndArray();
  json.EndArray();
}

void AddTriangle(io::JsonWriter& json, const Triangle& corners, const TriangleVector& triangle,
                 std::size_t row_length) {
  json.BeginObject();
  AddNumbers(json, "vertices", corners);
  json.Key("facing").Text(FacingWord(triangle.facing));
  const SampleRows must = RowsOf(triangle.must, row_length);
  json.Key("must_top").Integer(must.top);
  AddTexts(json, "must", must.rows);
  const SampleRows may = RowsOf(triangle.may, row_length);
  json.Key("may_top").Integer(may.top);
  AddTexts(json, "may", may.rows);
  json.EndObject();
}

void AddChannels(io::JsonWriter& json, const TestVector& vector) {
  if (vector.w.empty()) return;
  json.Key("w").BeginArray();
  for (const double w : vector.w) json.Exact(w);
  json.EndArray();
  json.Key("channels").BeginArray();
  for (const Channel& channel : vector.scene.channels) {
    json.BeginObject().Key("name").Text(channel.name);
    json.Key("interpolation").Text(NameIn(kInterpolationNames, channel.interpolation));
    json.Key("at").Text(NameIn(kEvaluatedAtNames, channel.at));
    json.Key("numbers").BeginArray();
    for (const double number : channel.values) json.Exact(number);
    json.EndArray().EndObject();
  }
  json.EndArray();
}

void AddNumber(io::JsonWriter& json, const NumberVector& number) {
  json.Key("exact").Text(number.exact);
  json.Key("nearest").Exact(static_cast<double>(number.nearest));
  json.Key("low").Exact(static_cast<double>(number.low));
  json.Key("high").Exact(static_cast<double>(number.high));
}

std::string ValueLine(const ValueVector& value, const TestVector& vector) {
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const auto width = static_cast<std::size_t>(vector.scene.width);
  io::JsonWriter json;
  json.BeginObjectLine();
  json.Key("value").Text(vector.name).Key("triangle").Integer(value.triangle);
  json.Key("column").Integer(value.sample / samples % width);
  json.Key("row").Integer(value.sample / samples / width);
  json.Key("sample").Integer(value.sample % samples);
  json.Key("channel").Text(vector.scene.channels[value.channel].name);
  AddNumber(json, value.value);
  if (value.derivatives) {
    const auto& [dx, dy] = *value.derivatives;
    AddNumber(json.Key("dx").BeginObject(), dx);
    AddNumber(json.EndObject().Key("dy").BeginObject(), dy);
    json.EndObject();
  }
  return json.EndObject().Finish();
}

std::string JointLine(const JointVector& joint, const TestVector& vector,
                      const VectorsHeader& header) {
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const std::size_t row_length = static_cast<std::size_t>(vector.scene.width) * samples;
  io::JsonWriter json;
  json.BeginObjectLine();
  json.Key("joint").Text(vector.name);
  json.Key("column").Integer(joint.sample % row_length / samples);
  json.Key("row").Integer(joint.sample / row_length);
  json.Key("sample").Integer(joint.sample % samples);
  AddNumbers(json, "triangles", joint.triangles);
  AddNumbers(json, "counts", joint.counts);
  json.Key("says").Text(JointText(joint));
  AddTexts(json, "clauses", header.joint_clauses);
  return json.EndObject().Finish();
}

}  // namespace

std::string_view FacingWord(int facing) {
  if (facing == 0) return "none";
  return facing > 0 ? "ccw" : "cw";
}

std::string JointText(const JointVector& joint) {
  const std::string of = joint.triangles.size() == 2
                             ? fmt::format("{}", fmt::join(joint.triangles, " and "))
                             : fmt::format("{}", fmt::join(joint.triangles, ", "));
  if (joint.counts.size() == 1 && joint.counts[0] == 1)
    return fmt::format("exactly one of triangles {} covers it", of);
  return fmt::format("{} of triangles {} cover it", fmt::join(joint.counts, " or "), of);
}

std::string VectorsHeaderLine(const VectorsHeader& header, std::string_view body) {
  io::JsonWriter json;
  json.BeginObjectLine();
  json.Key("rasterproof_vectors").Integer(kVectorsVersion);
  json.Key("program").Text(header.program);
  json.Key("profile_name").Text(header.profile.name);
  json.Key("profile").Value(io::WholeProfileLine(header.profile));
  json.Key("seed").Integer(header.seed).Key("level").Integer(header.level);
  if (!header.world.empty()) json.Key("world").Text(header.world);
  json.Key("lattice_bits").Integer(header.lattice_bits);
  json.Key("cases").Integer(header.cases).Key("triangles").Integer(header.triangles);
  json.Key("joints").Integer(header.joint);
  if (header.values) json.Key("values").Integer(*header.values);
  json.Key("body_fnv1a64").Text(HashText(body));
  const std::string hash = HashText(json.json());  // of all that comes before it
  return json.Key(kHeaderHashKey).Text(hash).EndObject().Finish();
}

std::string VectorLines(const TestVector& vector, const VectorsHeader& header) {
  const Scene& scene = vector.scene;
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const std::size_t row_length = static_cast<std::size_t>(scene.width) * samples;
  io::JsonWriter json;
  json.BeginObjectLine();
  json.Key("case").Text(vector.name);
  json.Key("width").Integer(scene.width).Key("height").Integer(scene.height);
  json.Key("y_axis").Text(AxisWord(vector.y_axis));
  AddPattern(json, vector.pattern);
  AddVertices(json, vector);
  AddChannels(json, vector);
  json.Key("triangles").BeginArray();
  for (std::size_t t = 0; t < vector.triangles.size(); ++t)
    AddTriangle(json, scene.triangles[t], vector.triangles[t], row_length);
  json.EndArray();
  AddTexts(json, "clauses", header.sample_clauses);
  json.Key("why").Text(vector.domain);
  json.Key("near_edges").BeginObject();
  json.Members(kNearEdgeCounters, vector.near_edges).EndObject();
  std::string lines = json.EndObject().Finish();
  for (const JointVector& joint : vector.joint) lines += JointLine(joint, vector, header);
  for (const ValueVector& value : vector.values) lines += ValueLine(value, vector);
  return lines;
}

}  // namespace rasterproof::report
