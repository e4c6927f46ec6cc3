#include "io/scene_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/quoted.h"
#include "io/json_document.h"
#include "io/json_writer.h"
#include "io/number_text.h"
#include "io/output.h"
#include "io/scene_json.h"
#include "io/value_json.h"

namespace rasterproof::io {
namespace {

constexpr int kSceneVersion = 1;
constexpr std::array<std::string_view, 8> kKeys{
    "rasterproof_scene", "name",     "width",     "height",
    "precision",         "vertices", "triangles", "channels"};

void RequireSceneVersion(const JsonValue& object) {
  if (!object.Find("rasterproof_scene")) {
    const bool is_case = object.Find("rasterproof_case").has_value();
    throw object.Error(
        is_case ? "is a case, not a scene"
                : "is not a scene: the key "
                  "\"rasterproof_scene\" is missing",
        is_case ? "give the object under its key \"scene\"" : "add \"rasterproof_scene\": 1");
  }
  const JsonValue version = object.Get("rasterproof_scene");
  if (version.RequireInteger(0, INT32_MAX) != kSceneVersion) {
    throw version.Error("version " + std::string(version.text()) + " is unknown",
                        "this program reads version 1");
  }
}

void ReadTarget(const JsonValue& object, Scene& scene) {
  scene.width = static_cast<int>(object.Get("width").RequireInteger(1, kMaxTargetSide));
  scene.height = static_cast<int>(object.Get("height").RequireInteger(1, kMaxTargetSide));
  const std::int64_t samples = std::int64_t{scene.width} * scene.height;
  if (samples > kMaxTargetSamples) {
    throw object.Error("the target of " + std::to_string(scene.width) + " x " +
                           std::to_string(scene.height) + " has " + std::to_string(samples) +
                           " samples",
                       "at most " + std::to_string(kMaxTargetSamples) + " are possible");
  }
}

Precision PrecisionFromJson(const JsonValue& value) {
  const std::string_view name = value.RequireString();
  if (name == "float32") return Precision::kFloat32;
  if (name == "float64") return Precision::kFloat64;
  throw value.Error(Quoted(name) + " is no precision", "write \"float32\" or \"float64\"");
}

// Reads one vertex; returns how many coordinates it is written with.
std::size_t ReadVertex(const JsonValue& item, Precision precision, Vertex& vertex) {
  const std::array<double*, 4> coordinates{&vertex.x, &vertex.y, &vertex.z, &vertex.w};
  std::size_t n = 0;
  for (const JsonValue value : item.RequireArray()) {
    if (n == coordinates.size()) break;
    *coordinates[n++] = CoordinateFromJson(value, precision);
  }
  const std::size_t size = item.RequireArray().size();
  if (size < 2 || size > coordinates.size()) {
    throw item.Error("has " + std::to_string(size) + " coordinates",
                     "write [x, y], [x, y, z] or, for clip space, [x, y, z, w]");
  }
  return n;
}

void ReadVertices(const JsonValue& list, Scene& scene) {
  std::optional<JsonValue> window;  // the first vertex without and with a fourth coordinate
  std::optional<JsonValue> clip;
  const JsonValue::Items items = list.RequireArray();
  scene.vertices.reserve(items.size());
  for (const JsonValue item : items) {
    Vertex& vertex = scene.vertices.emplace_back();
    std::optional<JsonValue>& first =
        ReadVertex(item, scene.precision, vertex) == 4 ? clip : window;
    if (!first) first = item;
  }
  scene.clip_space = clip.has_value();
  if (clip && window) {
    throw window->Error("has no w, but " + clip->Place() + " has",
                        "give all vertices four coordinates (clip space) or none");
  }
}

void ReadTriangles(const JsonValue& list, Scene& scene) {
  const auto vertices = static_cast<std::int64_t>(scene.vertices.size());
  const JsonValue::Items items = list.RequireArray();
  scene.triangles.reserve(items.size());
  for (const JsonValue item : items) {
    const JsonValue::Items corners = item.RequireArray();
    if (corners.size() != 3) {
      throw item.Error("has " + std::to_string(corners.size()) + " indices",
                       "write three: [i, j, k]");
    }
    Triangle& triangle = scene.triangles.emplace_back();
    std::size_t k = 0;
    for (const JsonValue corner : corners) {
      const std::int64_t index = corner.RequireInteger(INT32_MIN, INT32_MAX);
      if (index < 0 || index >= vertices) {
        throw corner.Error(
            "the index " + std::to_string(index) + " names no vertex",
            vertices == 0 ? "the scene has no vertices"
                          : "the vertices are numbered from 0 to " + std::to_string(vertices - 1));
      }
      triangle[k++] = static_cast<std::int32_t>(index);
    }
  }
}

// -0 counts: it is a bit of the scene.
bool HasZ(const Vertex& vertex) { return std::bit_cast<std::uint64_t>(vertex.z) != 0; }

void WriteVertex(JsonWriter& json, const Vertex& vertex, bool clip_space) {
  json.BeginArray(kOneLine).Exact(vertex.x).Exact(vertex.y);
  if (clip_space || HasZ(vertex)) json.Exact(vertex.z);
  if (clip_space) json.Exact(vertex.w);
  json.EndArray();
}

}  // namespace

double CoordinateFromJson(const JsonValue& value, Precision precision) {
  if (value.kind() != JsonKind::kNumber && value.kind() != JsonKind::kString) {
    throw value.Error("is neither a number nor a string", "write a coordinate");
  }
  const NumberFromText number = value.kind() == JsonKind::kNumber
                                    ? DecimalNumber(value.text(), precision)
                                    : ExactNumber(value.text(), precision);
  if (number.fault.empty()) return number.value;
  throw value.Error(Quoted(value.text()) + " " + std::string(number.fault),
                    std::string(number.remedy));
}

Scene SceneFromJson(const JsonValue& object) {
  if (object.kind() == JsonKind::kObject) RequireSceneVersion(object);
  object.RequireObject(kKeys);
  Scene scene;
  if (const auto name = object.Find("name")) scene.name = name->RequireString();
  ReadTarget(object, scene);
  if (const auto precision = object.Find("precision")) {
    scene.precision = PrecisionFromJson(*precision);
  }
  ReadVertices(object.Get("vertices"), scene);
  ReadTriangles(object.Get("triangles"), scene);
  if (const auto channels = object.Find("channels"))
    scene.channels = ChannelsFromJson(*channels, scene.vertices.size(), scene.precision);
  return scene;
}

void WriteScene(JsonWriter& json, const Scene& scene) {
  json.BeginObject().Key("rasterproof_scene").Integer(kSceneVersion);
  json.Key("name").Text(scene.name);
  json.Key("width").Integer(scene.width).Key("height").Integer(scene.height);
  json.Key("precision").Text(scene.precision == Precision::kFloat32 ? "float32" : "float64");
  json.Key("vertices").BeginArray(kEndOnLastLine);
  for (const Vertex& vertex : scene.vertices) WriteVertex(json, vertex, scene.clip_space);
  json.EndArray().Key("triangles").BeginArray(kEndOnLastLine);
  for (const Triangle& t : scene.triangles) {
    json.BeginArray(kOneLine).Integer(t[0]).Integer(t[1]).Integer(t[2]).EndArray();
  }
  json.EndArray();
  if (!scene.channels.empty()) {
    json.Key("channels");
    WriteChannels(json, scene.channels);
  }
  json.EndObject();
}

Scene ParseScene(std::string_view text, const std::string& place) {
  const JsonDocument document(text, place);
  return SceneFromJson(document.root());
}

Scene ReadScene(const std::string& path) {
  return ParseScene(ReadFile(path), path == "-" ? "standard input" : path);
}

std::string SceneToJson(const Scene& scene) {
  JsonWriter json;
  WriteScene(json, scene);
  return json.Finish();
}

}  // namespace rasterproof::io
