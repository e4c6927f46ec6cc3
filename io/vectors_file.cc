#include "io/vectors_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/hash_text.h"
#include "core/quoted.h"
#include "core/sample_rows.h"
#include "core/target_size.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/number_text.h"
#include "io/profile_json.h"

namespace rasterproof::io {
namespace {

constexpr std::array<std::string_view, 14> kHeaderKeys{"rasterproof_vectors",
                                                       "program",
                                                       "profile_name",
                                                       "profile",
                                                       "seed",
                                                       "level",
                                                       "world",
                                                       "lattice_bits",
                                                       "cases",
                                                       "triangles",
                                                       "joints",
                                                       "values",
                                                       "body_fnv1a64",
                                                       kHeaderHashKey};
constexpr std::array<std::string_view, 13> kVectorKeys{
    "case", "width",    "height",    "y_axis",  "samples_256", "vertices",  "fixed",
    "w",    "channels", "triangles", "clauses", "why",         "near_edges"};
constexpr std::array<std::string_view, 6> kTriangleKeys{"vertices", "facing",  "must_top",
                                                        "must",     "may_top", "may"};
constexpr std::array<std::string_view, 8> kJointKeys{"joint",     "column", "row",  "sample",
                                                     "triangles", "counts", "says", "clauses"};
constexpr std::array<std::string_view, 4> kAnswerKeys{"case", "triangle", "top", "rows"};
constexpr std::array<std::pair<int, std::string_view>, 3> kFacings{
    {{1, "ccw"}, {-1, "cw"}, {0, "none"}}};
constexpr std::array<std::pair<YAxis, std::string_view>, 2> kAxes{
    {{YAxis::kDown, "down"}, {YAxis::kUp, "up"}}};
constexpr std::string_view kAgain = "generate the file again";

std::string LinePlace(const std::string& place, std::size_t number) {
  return place + ": line " + std::to_string(number);
}

// Calls `read` with each line that is not empty, and its number.
template <class Read>
void ReadLines(std::string_view text, std::size_t number, const Read& read) {
  for (; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (text.substr(0, end).find_first_not_of(" \t\r") != std::string_view::npos)
      read(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::vector<std::string> TextsFromJson(const JsonValue& value) {
  std::vector<std::string> texts;
  for (const JsonValue item : value.RequireArray()) texts.push_back(item.RequireName());
  return texts;
}

std::size_t Index(const JsonValue& value, std::size_t end) {
  if (end == 0) throw value.Error("names a missing number", std::string(kAgain));
  return static_cast<std::size_t>(value.RequireInteger(0, static_cast<std::int64_t>(end) - 1));
}

// The samples of hexadecimal rows from row `top` on.
std::vector<std::size_t> SamplesFromJson(const JsonValue& rows, std::size_t top,
                                         const TestVector& vector) {
  const auto height = static_cast<std::size_t>(vector.scene.height);
  const std::size_t row_length = static_cast<std::size_t>(vector.scene.width) *
                                 static_cast<std::size_t>(vector.pattern.samples());
  std::vector<std::size_t> samples;
  std::size_t row = top;
  for (const JsonValue item : rows.RequireArray()) {
    if (row >= height) {
      throw item.Error("lies below the target, which has " + std::to_string(height) + " rows",
                       "give the rows of the target, from row " + std::to_string(top) + " on");
    }
    const std::string_view why = AddRow(item.RequireString(), row++, row_length, samples);
    if (!why.empty()) {
      throw item.Error(Quoted(item.text(), 80) + " " + std::string(why),
                       "write a row of " + std::to_string(row_length) +
                           " samples as a hexadecimal number, the first sample as its last bit");
    }
  }
  return samples;
}

double ExactFromJson(const JsonValue& value) {
  const NumberFromText number = ExactNumber(value.RequireString(), Precision::kFloat32);
  if (!number.fault.empty())
    throw value.Error(std::string(number.fault), std::string(number.remedy));
  return number.value;
}

// Calls `take` with the two items of each pair.
template <class Take>
void ReadPairs(const JsonValue& value, const Take& take) {
  for (const JsonValue pair : value.RequireArray()) {
    const JsonValue::Items items = pair.RequireArray();
    if (items.size() != 2) throw pair.Error("is no pair", "write [x, y]");
    const JsonValue first = *items.begin();
    take(first, *++items.begin());
  }
}

void ReadPlaces(const JsonValue& object, TestVector& vector) {
  vector.pattern.locations.clear();
  ReadPairs(object.Get("samples_256"), [&](const JsonValue& x, const JsonValue& y) {
    vector.pattern.locations.push_back({Integer(x, 0, 255) / 256.0, Integer(y, 0, 255) / 256.0});
  });
  const int samples = vector.pattern.samples();
  if (samples == 0 || samples > kMaxSamplesPerPixel)
    throw object.Get("samples_256").Error("has no sample, or more than 64", std::string(kAgain));
  ReadPairs(object.Get("vertices"), [&](const JsonValue& x, const JsonValue& y) {
    vector.scene.vertices.push_back({ExactFromJson(x), ExactFromJson(y)});
  });
  const JsonValue fixed = object.Get("fixed");
  if (fixed.kind() == JsonKind::kNull) return;
  vector.on_lattice.emplace();
  ReadPairs(fixed, [&](const JsonValue& x, const JsonValue& y) {
    vector.on_lattice->push_back(
        {Integer(x, INT32_MIN, INT32_MAX), Integer(y, INT32_MIN, INT32_MAX)});
  });
}

void ReadTriangle(const JsonValue& value, TestVector& vector) {
  value.RequireObject(kTriangleKeys);
  const JsonValue::Items corners = value.Get("vertices").RequireArray();
  if (corners.size() != 3)
    throw value.Get("vertices").Error("does not have three corners", std::string(kAgain));
  Triangle triangle{};
  std::size_t k = 0;
  for (const JsonValue corner : corners)
    triangle[k++] = static_cast<std::int32_t>(Index(corner, vector.scene.vertices.size()));
  vector.scene.triangles.push_back(triangle);
  TriangleVector& states = vector.triangles.emplace_back();
  states.facing = FromName(value.Get("facing"), Names<int>(kFacings));
  const auto height = static_cast<std::size_t>(vector.scene.height);
  states.must = SamplesFromJson(value.Get("must"), Index(value.Get("must_top"), height), vector);
  states.may = SamplesFromJson(value.Get("may"), Index(value.Get("may_top"), height), vector);
}

TestVector VectorFromJson(const JsonValue& object) {
  object.RequireObject(kVectorKeys);
  TestVector vector;
  vector.name = object.Get("case").RequireName();
  vector.scene.name = vector.name;
  vector.scene.width = Integer(object.Get("width"), 1, kMaxTargetSide);
  vector.scene.height = Integer(object.Get("height"), 1, kMaxTargetSide);
  vector.y_axis = FromName(object.Get("y_axis"), Names<YAxis>(kAxes));
  ReadPlaces(object, vector);
  RequireTargetSize(object.Place(), vector.scene.width, vector.scene.height,
                    vector.pattern.samples());
  for (const JsonValue triangle : object.Get("triangles").RequireArray())
    ReadTriangle(triangle, vector);
  vector.domain = object.Get("why").RequireName();
  const JsonValue near = object.Get("near_edges");
  for (const auto& [name, counter] : kNearEdgeCounters)
    vector.near_edges.*counter =
        static_cast<std::uint64_t>(near.Get(name).RequireInteger(0, INT64_MAX));
  return vector;
}

JointVector JointFromJson(const JsonValue& object, const TestVector& vector) {
  object.RequireObject(kJointKeys);
  const auto width = static_cast<std::size_t>(vector.scene.width);
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const std::size_t row = Index(object.Get("row"), static_cast<std::size_t>(vector.scene.height));
  JointVector joint;
  joint.sample = (row * width + Index(object.Get("column"), width)) * samples +
                 Index(object.Get("sample"), samples);
  for (const JsonValue t : object.Get("triangles").RequireArray())
    joint.triangles.push_back(Index(t, vector.triangles.size()));
  for (const JsonValue count : object.Get("counts").RequireArray())
    joint.counts.push_back(static_cast<int>(Index(count, joint.triangles.size() + 1)));
  return joint;
}

void RequireHash(const JsonValue& hash, std::string_view text, std::string_view whose) {
  if (hash.RequireString() == HashText(text)) return;
  throw hash.Error("is not the hash of " + std::string(whose) + ", " + HashText(text) +
                       ": the file is damaged or was changed",
                   std::string(kAgain));
}

VectorsHeader HeaderFromJson(const JsonValue& object, std::string_view line,
                             std::string_view body) {
  const JsonValue version = object.Get("rasterproof_vectors");
  if (version.RequireInteger(0, INT32_MAX) != kVectorsVersion) {
    throw version.Error("version " + std::string(version.text()) + " is unknown",
                        "this program reads version " + std::to_string(kVectorsVersion) + ": " +
                            std::string(kAgain) + " with it");
  }
  object.RequireObject(kHeaderKeys);
  VectorsHeader header;
  header.program = object.Get("program").RequireName();
  // A preset is written as its keys, and means what it meant then.
  header.profile.name = object.Get("profile_name").RequireName();
  header.lattice_bits = Integer(object.Get("lattice_bits"), 0, 32);
  ReadIfThere(object, "world", header.world, [](const JsonValue& v) { return v.RequireName(); });
  header.level = Integer(object.Get("level"), 1, INT32_MAX);
  const auto number = [&](std::string_view key) {
    return static_cast<std::uint64_t>(object.Get(key).RequireInteger(0, INT64_MAX));
  };
  header.cases = number("cases");
  header.triangles = number("triangles");
  header.joint = number("joints");
  RequireHash(object.Get("body_fnv1a64"), body, "the lines after it");
  const std::string last = ",\"" + std::string(kHeaderHashKey) + "\"";
  RequireHash(object.Get(kHeaderHashKey), line.substr(0, line.rfind(last)), "what comes before it");
  return header;
}

}  // namespace

VectorsFile ParseVectors(std::string_view text, const std::string& place) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view body = text.substr(std::min(end + 1, text.size()));
  const JsonDocument first(text.substr(0, end), LinePlace(place, 1));
  VectorsFile file;
  file.header = HeaderFromJson(first.root(), text.substr(0, end), body);
  std::unordered_map<std::string, std::size_t> names;
  ReadLines(body, 2, [&](std::string_view line, std::size_t number) {
    const JsonDocument document(line, LinePlace(place, number));
    const JsonValue object = document.root();
    if (object.kind() == JsonKind::kObject && object.Find("value")) return;
    if (object.kind() == JsonKind::kObject && object.Find("joint")) {
      const JsonValue name = object.Get("joint");
      const auto found = names.find(name.RequireName());
      if (found == names.end()) throw name.Error("names no case above", std::string(kAgain));
      TestVector& vector = file.vectors[found->second];
      vector.joint.push_back(JointFromJson(object, vector));
      if (file.header.joint_clauses.empty())
        file.header.joint_clauses = TextsFromJson(object.Get("clauses"));
      return;
    }
    file.vectors.push_back(VectorFromJson(object));
    file.header.sample_clauses = TextsFromJson(object.Get("clauses"));
    if (!names.emplace(file.vectors.back().name, file.vectors.size() - 1).second)
      throw object.Get("case").Error("is there twice", std::string(kAgain));
  });
  return file;
}

VectorAnswers ParseAnswers(std::string_view text, const std::string& place,
                           const std::vector<TestVector>& vectors) {
  std::unordered_map<std::string_view, std::size_t> names;
  for (std::size_t v = 0; v < vectors.size(); ++v) names.emplace(vectors[v].name, v);
  VectorAnswers answers;
  ReadLines(text, 1, [&](std::string_view line, std::size_t number) {
    const JsonDocument document(line, LinePlace(place, number));
    const JsonValue object = document.root();
    object.RequireObject(kAnswerKeys);
    const JsonValue name = object.Get("case");
    const auto found = names.find(name.RequireString());
    if (found == names.end()) {
      throw name.Error("the vectors have no case " + Quoted(name.text(), 80),
                       "answer cases of this file of vectors alone");
    }
    const TestVector& vector = vectors[found->second];
    const std::size_t t = Index(object.Get("triangle"), vector.triangles.size());
    std::size_t top = 0;
    ReadIfThere(object, "top", top, [&](const JsonValue& value) {
      return Index(value, static_cast<std::size_t>(vector.scene.height));
    });
    const bool is_new =
        answers
            .emplace(std::pair(found->second, t), SamplesFromJson(object.Get("rows"), top, vector))
            .second;
    if (!is_new) {
      throw object.Get("triangle").Error("is answered twice", "answer each triangle once");
    }
  });
  return answers;
}

}  // namespace rasterproof::io
