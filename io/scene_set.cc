#include "io/scene_set.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quoted.h"
#include "core/scene.h"
#include "io/json_document.h"
#include "io/output.h"

namespace rasterproof::io {
namespace {

constexpr std::array<std::string_view, 2> kSetKeys{"rasterproof_scene_set", "scenes"};
constexpr std::array<std::string_view, 8> kEntryKeys{"name",   "summary", "kind",  "path",
                                                     "camera", "project", "width", "height"};

bool IsReal(const JsonValue& kind) {
  const std::string_view text = kind.RequireString();
  if (text == "real") return true;
  if (text == "hard") return false;
  throw kind.Error(Quoted(text) + " is unknown", "write \"real\" or \"hard\"");
}

int Side(const JsonValue& value) {
  return static_cast<int>(value.RequireInteger(1, kMaxTargetSide));
}

SceneEntry ReadEntry(const JsonValue& object, const std::filesystem::path& folder) {
  object.RequireObject(kEntryKeys);
  SceneEntry entry;
  entry.name = object.Get("name").RequireName();
  // An absolute path stays as it is.
  entry.path = (folder / object.Get("path").RequireString()).string();
  if (const auto summary = object.Find("summary")) entry.summary = summary->RequireString();
  if (const auto kind = object.Find("kind")) entry.real = IsReal(*kind);
  if (const auto camera = object.Find("camera")) entry.camera = camera->RequireString();
  if (const auto project = object.Find("project")) entry.project = project->RequireString();
  if (const auto width = object.Find("width")) entry.width = Side(*width);
  if (const auto height = object.Find("height")) entry.height = Side(*height);
  return entry;
}

}  // namespace

std::vector<SceneEntry> ReadSceneSet(const std::string& path) {
  const std::string text = ReadFile(path);
  const JsonDocument document(text, path == "-" ? "standard input" : path);
  const JsonValue root = document.root();
  root.RequireObject(kSetKeys);
  root.Get("rasterproof_scene_set").RequireInteger(1, 1);  // the version
  std::vector<SceneEntry> entries;
  const JsonValue list = root.Get("scenes");
  for (const JsonValue item : list.RequireArray()) {
    entries.push_back(ReadEntry(item, std::filesystem::path(path).parent_path()));
  }
  if (entries.empty()) throw list.Error("names no scene", "add one");
  return entries;
}

}  // namespace rasterproof::io
