#include "io/case_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile_keys.h"
#include "core/quoted.h"
#include "core/suggestion.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "io/profile_json.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr int kCaseVersion = 2;
constexpr int kMaxTile = kMaxTargetSide;
constexpr int kMaxThreads = 4096;

constexpr std::array<std::string_view, 9> kCaseKeys{"rasterproof_case", "scene",   "profile",
                                                    "options",          "subject", "property",
                                                    "origin",           "drawn",   "drawing"};
constexpr std::array<std::string_view, 4> kDrawingMembers{"shows", "visible", "numbers", "fronts"};
constexpr std::array<std::string_view, 3> kVisibleWords{"any", "last", "first"};
constexpr std::array<std::string_view, 2> kDrawnKeys{"options", "scene"};
constexpr std::array<std::string_view, 4> kOptionKeys{"cull", "scissor", "tile", "threads"};

constexpr std::array<std::pair<Cull, std::string_view>, 3> kCulls{
    {{Cull::kNone, "none"}, {Cull::kFront, "front"}, {Cull::kBack, "back"}}};

constexpr std::array<std::pair<DrawingShows, std::string_view>, 3> kShows{
    {{DrawingShows::kCounts, "counts"},
     {DrawingShows::kMask, "mask"},
     {DrawingShows::kIds, "ids"}}};

std::optional<PixelRect> ScissorFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const JsonValue::Items sides = value.RequireArray();
  if (sides.size() != 4) {
    throw value.Error("has " + std::to_string(sides.size()) + " sides",
                      "write [x0, y0, x1, y1], or null");
  }
  PixelRect rect;
  const std::array<int*, 4> into{&rect.x0, &rect.y0, &rect.x1, &rect.y1};
  std::size_t k = 0;
  for (const JsonValue side : sides) *into[k++] = Integer(side, INT32_MIN, INT32_MAX);
  return rect;
}

DrawOptions OptionsFromJson(const JsonValue& value) {
  value.RequireObject(kOptionKeys);
  DrawOptions options;
  ReadIfThere(value, "cull", options.cull,
              [](const JsonValue& v) { return FromName(v, Names<Cull>(kCulls)); });
  ReadIfThere(value, "scissor", options.scissor, ScissorFromJson);
  ReadIfThere(value, "tile", options.tile,
              [](const JsonValue& v) { return Integer(v, 0, kMaxTile); });
  ReadIfThere(value, "threads", options.threads,
              [](const JsonValue& v) { return Integer(v, 0, kMaxThreads); });
  return options;
}

std::shared_ptr<const DrawnScene> DrawnFromJson(const JsonValue& value) {
  value.RequireObject(kDrawnKeys);
  DrawnScene drawn;
  drawn.scene = SceneFromJson(value.Get("scene"));
  ReadIfThere(value, "options", drawn.options, OptionsFromJson);
  return std::make_shared<const DrawnScene>(std::move(drawn));
}

// Rows of numbers, all of one length.
std::vector<std::uint32_t> RowsFromJson(const JsonValue& value, int height) {
  const JsonValue::Items rows = value.RequireArray();
  if (rows.size() != static_cast<std::size_t>(height)) {
    throw value.Error(
        "has " + std::to_string(rows.size()) + " rows, the target " + std::to_string(height),
        "give one row of numbers for each row of pixels");
  }
  std::vector<std::uint32_t> numbers;
  std::optional<std::size_t> length;
  for (const JsonValue row : rows) {
    const JsonValue::Items items = row.RequireArray();
    if (items.size() != length.value_or(items.size())) {
      throw row.Error("has " + std::to_string(items.size()) + " numbers, the rows above " +
                          std::to_string(*length),
                      "give one number for each sample");
    }
    length = items.size();
    for (const JsonValue item : items)
      numbers.push_back(static_cast<std::uint32_t>(item.RequireInteger(0, UINT32_MAX)));
  }
  return numbers;
}

CaseDrawing DrawingFromJson(const JsonValue& value, int height) {
  value.RequireObject(kDrawingMembers);
  const auto rows = [&](const JsonValue& v) { return RowsFromJson(v, height); };
  CaseDrawing drawing;
  drawing.shows = FromName(value.Get("shows"), Names<DrawingShows>(kShows));
  ReadIfThere(value, "visible", drawing.visible, [](const JsonValue& v) {
    return std::string(kVisibleWords[IndexOf(v, kVisibleWords)]);
  });
  drawing.numbers = rows(value.Get("numbers"));
  ReadIfThere(value, "fronts", drawing.fronts, rows);
  return drawing;
}

void WriteRows(JsonWriter& json, std::string_view key, const std::vector<std::uint32_t>& numbers,
               int height) {
  const std::size_t length = numbers.size() / static_cast<std::size_t>(height);
  json.Key(key).BeginArray(kFromThisLine);
  for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
    json.BeginArray(kOneLine);
    for (std::size_t k = 0; k < length; ++k) json.Integer(numbers[row * length + k]);
    json.EndArray();
  }
  json.EndArray();
}

void WriteDrawing(JsonWriter& json, const CaseDrawing& drawing, int height) {
  json.BeginObject().Key("shows").Text(NameOf(drawing.shows, Names<DrawingShows>(kShows)));
  json.Key("visible").Text(drawing.visible);
  WriteRows(json, "numbers", drawing.numbers, height);
  if (!drawing.fronts.empty()) WriteRows(json, "fronts", drawing.fronts, height);
  json.EndObject();
}

std::string NameFromJson(const JsonValue& value) { return value.RequireName(); }
// As it is: a program's command is run, and whoever shows it quotes it.
std::string TextFromJson(const JsonValue& value) { return std::string(value.RequireString()); }

void RequireCaseVersion(const JsonValue& object) {
  const JsonValue version = object.Get("rasterproof_case");
  if (version.RequireInteger(0, INT32_MAX) == kCaseVersion) return;
  throw version.Error(
      "version " + std::string(version.text()) + " is unknown",
      "this program reads version 2: write 2, and it names the new word for each old one");
}

CaseFile CaseFromJson(const JsonValue& object) {
  CaseFile file;
  if (object.kind() == JsonKind::kObject && !object.Find("rasterproof_case")) {
    file.value.scene = SceneFromJson(object);
    return file;
  }
  object.RequireObject(kCaseKeys);
  RequireCaseVersion(object);
  file.value.scene = SceneFromJson(object.Get("scene"));
  ReadIfThere(object, "profile", file.value.profile, ProfileFromJson);
  file.states_profile = object.Find("profile").has_value();
  ReadIfThere(object, "options", file.value.options, OptionsFromJson);
  ReadIfThere(object, "origin", file.value.origin, NameFromJson);
  ReadIfThere(object, "subject", file.subject, TextFromJson);
  ReadIfThere(object, "property", file.property, NameFromJson);
  ReadIfThere(object, "drawn", file.drawn, DrawnFromJson);
  ReadIfThere(object, "drawing", file.drawing, [&](const JsonValue& value) {
    return DrawingFromJson(value, file.value.scene.height);
  });
  return file;
}

void WriteOptions(JsonWriter& json, const DrawOptions& options) {
  json.BeginObject(kOneLine).Key("cull").Text(NameOf(options.cull, Names<Cull>(kCulls)));
  if (const std::optional<PixelRect>& s = options.scissor) {
    json.Key("scissor").BeginArray().Integer(s->x0).Integer(s->y0);
    json.Integer(s->x1).Integer(s->y1).EndArray();
  }
  json.Key("tile").Integer(options.tile).Key("threads").Integer(options.threads).EndObject();
}

std::string NameOfFile(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace

CaseFile ParseCase(std::string_view text, const std::string& place) {
  const JsonDocument document(text, place);
  return CaseFromJson(document.root());
}

CaseFile ReadCase(const std::string& path) { return ParseCase(ReadFile(path), NameOfFile(path)); }

std::string CaseToJson(const CaseFile& file) {
  JsonWriter json;
  json.BeginObject().Key("rasterproof_case").Integer(kCaseVersion);
  json.Key("subject").Text(file.subject).Key("property").Text(file.property);
  json.Key("origin").Text(file.value.origin);
  WriteProfile(json.Key("profile"), file.value.profile);
  WriteOptions(json.Key("options"), file.value.options);
  WriteScene(json.Key("scene"), file.value.scene);
  if (file.drawn != nullptr) {
    json.Key("drawn").BeginObject();
    WriteOptions(json.Key("options"), file.drawn->options);
    WriteScene(json.Key("scene"), file.drawn->scene);
    json.EndObject();
  }
  if (file.drawing) WriteDrawing(json.Key("drawing"), *file.drawing, file.value.scene.height);
  return json.EndObject().Finish();
}

namespace {

// A contract is what a profile promises, and no profile.
std::string ContractHint(const std::string& name) {
  for (const Contract contract :
       {Contract::kSampleExact, Contract::kWatertight, Contract::kClosed}) {
    if (name == ContractName(contract))
      return "it is a contract: write '{\"contract\": \"" + name + "\"}'; ";
  }
  return "";
}

}  // namespace

Profile ReadProfile(const std::string& path_or_preset) {
  if (const std::optional<Profile> preset = PresetProfile(path_or_preset)) return *preset;
  if (path_or_preset.starts_with('{')) return ParseProfile(path_or_preset, "the profile");
  if (path_or_preset != "-" && !IsThere(path_or_preset)) {
    throw InputError("profile " + Quoted(path_or_preset), "is neither a preset nor a file",
                     ContractHint(path_or_preset) + Suggestion(path_or_preset, PresetNames()) +
                         "the presets are" + ListedNames(PresetNames()));
  }
  return ParseProfile(ReadFile(path_or_preset), NameOfFile(path_or_preset));
}

Profile ParseProfile(const std::string& text_or_preset, const std::string& place) {
  if (const std::optional<Profile> preset = PresetProfile(text_or_preset)) return *preset;
  const JsonDocument document(text_or_preset, place);
  return ProfileFromJson(document.root());
}

}  // namespace rasterproof::io
