#include "web/engine/oracle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/quoted.h"
#include "core/suggestion.h"
#include "core/target_size.h"
#include "exact/attributes.h"
#include "exact/edge.h"
#include "exact/placed_scene.h"
#include "exact/rational.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/json_writer.h"
#include "io/profile_json.h"
#include "io/scene_json.h"
#include "legal/alone.h"
#include "subjects/builtin/builtin.h"

namespace rasterproof::web {
namespace {

using exact::Rational;
using io::JsonValue;
using io::JsonWriter;

Point2 PointOf(const JsonValue& value) {
  std::array<double, 2> numbers{};
  std::size_t read = 0;
  for (const JsonValue number : value.RequireArray()) {
    if (read == 2) break;
    numbers[read++] = io::CoordinateFromJson(number, Precision::kFloat64);
  }
  if (value.RequireArray().size() != 2) throw value.Error("is no point", "write [x, y]");
  return {numbers[0], numbers[1]};
}

// One triangle and the sample that is asked about.
struct Asked {
  Scene scene;
  Profile profile;
  int column = 0;
  int row = 0;
  int sample = 0;
};

Asked AskedOf(const JsonValue& root) {
  constexpr std::array<std::string_view, 6> kKeys{"triangle", "pixel", "sample",
                                                  "profile",  "width", "height"};
  root.RequireObject(kKeys);
  Asked asked;
  if (const auto profile = root.Find("profile")) asked.profile = ProfileFromJson(*profile);
  Scene& scene = asked.scene;
  scene.name = "triangle";
  scene.precision = Precision::kFloat64;
  scene.width = scene.height = 64;
  const auto side = [](const JsonValue& value) { return io::Integer(value, 1, kMaxTargetSide); };
  io::ReadIfThere(root, "width", scene.width, side);
  io::ReadIfThere(root, "height", scene.height, side);
  RequireTargetSize("width, height", scene.width, scene.height, asked.profile.pattern.samples());
  for (const JsonValue corner : root.Get("triangle").RequireArray()) {
    const Point2 at = PointOf(corner);
    scene.vertices.push_back({at.x, at.y});
  }
  if (scene.vertices.size() != 3)
    throw root.Get("triangle").Error("has not three vertices", "give [[x, y], [x, y], [x, y]]");
  scene.triangles = {{0, 1, 2}};
  std::size_t read = 0;
  const JsonValue pixel = root.Get("pixel");
  for (const JsonValue number : pixel.RequireArray()) {
    (read == 0 ? asked.column : asked.row) =
        io::Integer(number, 0, (read == 0 ? scene.width : scene.height) - 1);
    if (++read > 1) break;
  }
  if (pixel.RequireArray().size() != 2) throw pixel.Error("is no pixel", "write [column, row]");
  const int last = asked.profile.pattern.samples() - 1;
  io::ReadIfThere(root, "sample", asked.sample,
                  [&](const JsonValue& value) { return io::Integer(value, 0, last); });
  return asked;
}

template <class Numbers>
void AddNumbers(JsonWriter& json, std::string_view key, const Numbers& numbers) {
  json.Key(key).BeginArrayLine();
  for (const double number : numbers) json.Shortest(number);
  json.EndArray();
}

void AddRationals(JsonWriter& json, const std::string& key, std::span<const Rational> numbers) {
  json.Key(key).BeginArrayLine();
  for (const Rational& number : numbers) json.Shortest(number.ToDouble());
  json.EndArray().Key(key + "_exact").BeginArrayLine();
  for (const Rational& number : numbers) json.Text(number.ToString());
  json.EndArray();
}

std::array<Point2, 3> PointsOf(const Scene& scene, const Triangle& triangle) {
  const std::array<Vertex, 3> v = Corners(scene, triangle);
  return {WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
}

bool IsFinite(const std::array<Point2, 3>& v) {
  return std::ranges::all_of(v, [](Point2 p) { return p.x - p.x == 0 && p.y - p.y == 0; });
}

}  // namespace

std::string Covers(std::string_view text) {
  const io::JsonDocument document(text, "covers");
  const Asked asked = AskedOf(document.root());
  if (const auto why = legal::WhyNotAlone(asked.scene, asked.profile))
    throw InputError("covers", *why, "give another profile, or another triangle");
  const exact::PlacedScene placed(asked.scene, asked.profile);
  const legal::TriangleDecided decided = legal::DecideAlone(asked.scene, asked.profile).front();
  const CoverageCounts shape(asked.scene.width, asked.scene.height,
                             placed.profile.pattern.samples());
  const std::size_t sample = shape.Index(asked.column, asked.row, asked.sample);
  const bool may = decided.is_anything || std::ranges::binary_search(decided.may, sample);
  const bool must = std::ranges::binary_search(decided.must, sample);
  const bool is_up = placed.profile.y_axis == YAxis::kUp;
  const Point2 at = placed.profile.pattern.At(
      asked.column, is_up ? asked.scene.height - 1 - asked.row : asked.row, asked.sample);
  JsonWriter json;
  json.BeginObjectLine().Key("covers").Text(may ? "may" : must ? "must" : "must not");
  json.Key("facing").Integer(int{placed.facings.front()});
  AddNumbers(json, "at", std::array{at.x, at.y});
  const std::array<Point2, 3> v = PointsOf(placed.placed, {0, 1, 2});
  if (!placed.why_not_placed && IsFinite(v)) {
    const std::array<Rational, 3> edges{exact::EdgeValue(v[1], v[2], at),
                                        exact::EdgeValue(v[2], v[0], at),
                                        exact::EdgeValue(v[0], v[1], at)};
    AddNumbers(json, "placed", std::array{v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y});
    AddRationals(json, "edges", edges);
    if (const auto weights = exact::Barycentrics(v, at))
      AddRationals(json, "barycentrics", *weights);
  }
  return json.EndObject().Finish();
}

namespace {

void AddEdges(JsonWriter& json, const Subject& subject, const Scene& scene, Point2 at) {
  const EdgeEvaluator* const edges = subject.Edges();
  const BarycentricEvaluator* const weights = subject.Barycentrics();
  json.Key("triangles").BeginArray();
  for (const Triangle& triangle : scene.triangles) {
    const std::array<Point2, 3> v = PointsOf(scene, triangle);
    json.BeginObjectLine();
    if (edges != nullptr) {
      AddNumbers(json, "edges",
                 std::array{edges->Value(v[1], v[2], at), edges->Value(v[2], v[0], at),
                            edges->Value(v[0], v[1], at)});
    } else {
      json.Key("edges").Null();
    }
    if (weights != nullptr) {
      AddNumbers(json, "barycentrics", weights->Barycentrics(BarycentricForm::kVertexArea, v, at));
    } else {
      json.Key("barycentrics").Null();
    }
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace

std::string Draw(std::string_view text) {
  constexpr std::array<std::string_view, 3> kKeys{"method", "scene", "at"};
  const io::JsonDocument document(text, "draw");
  const JsonValue root = document.root();
  root.RequireObject(kKeys);
  const JsonValue method = root.Get("method");
  const std::unique_ptr<Subject> subject = subjects::MakeBuiltin(method.RequireString());
  if (subject == nullptr) {
    const std::vector<std::string> names = subjects::BuiltinNames();
    throw method.Error(
        "there is no method " + Quoted(method.text()),
        Suggestion(method.text(), std::vector<std::string_view>(names.begin(), names.end())) +
            "ask methods()");
  }
  const Scene scene = io::SceneFromJson(root.Get("scene"));
  if (!Takes(subject->Info(), scene))
    throw root.Get("scene").Error("is not for this method", "give its space and precision");
  const Drawing drawing =
      DrawOne(*subject, DrawJob(scene, {}, subject->Info().profile.pattern.samples()));
  JsonWriter json;
  json.BeginObject().Key("width").Integer(scene.width).Key("height").Integer(scene.height);
  json.Key("profile");
  io::WriteProfile(json, subject->Info().profile);
  json.Key("counts").BeginArrayLine();
  for (std::size_t k = 0; k < drawing.counts.size(); ++k) json.Integer(drawing.counts.Count(k));
  json.EndArray();
  if (const auto at = root.Find("at"); at && !scene.clip_space)
    AddEdges(json, *subject, scene, PointOf(*at));
  return json.EndObject().Finish();
}

std::string Methods() {
  JsonWriter json;
  json.BeginArrayLine();
  for (const std::string& name : subjects::BuiltinNames()) json.Text(name);
  return json.EndArray().Finish();
}

}  // namespace rasterproof::web
