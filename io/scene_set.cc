#include "io/scene_set.h"

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "io/output.h"
#include "nlohmann/json.hpp"

namespace rasterproof::io {
namespace {

using Json = nlohmann::json;

[[noreturn]] void Fail(const std::string& place, const std::string& reason) {
  throw InputError(place, reason,
                   "compare with scenes/certify.json, which lists the keys of an entry");
}

std::string Text(const Json& value, const std::string& place) {
  if (!value.is_string()) Fail(place, "expected a string");
  return value.get<std::string>();
}

int Side(const Json& value, const std::string& place) {
  constexpr int kLargest = 65536;
  if (!value.is_number_integer() || value.get<double>() < 1 || value.get<double>() > kLargest) {
    Fail(place, "expected an integer from 1 to 65536");
  }
  return value.get<int>();
}

SceneEntry ReadEntry(const Json& object, const std::filesystem::path& folder,
                     const std::string& place) {
  if (!object.is_object()) Fail(place, "expected an object");
  SceneEntry entry;
  for (const auto& [key, value] : object.items()) {
    const std::string here = place + "." + key;
    if (key == "name") {
      entry.name = Text(value, here);
    } else if (key == "kind") {
      const std::string kind = Text(value, here);
      if (kind != "real" && kind != "hard") Fail(here, "expected \"real\" or \"hard\"");
      entry.real = kind == "real";
    } else if (key == "path") {
      entry.path = (folder / Text(value, here)).string();  // an absolute path stays as it is
    } else if (key == "camera") {
      entry.camera = Text(value, here);
    } else if (key == "project") {
      entry.project = Text(value, here);
    } else if (key == "width") {
      entry.width = Side(value, here);
    } else if (key == "height") {
      entry.height = Side(value, here);
    } else {
      Fail(here, "unknown key");
    }
  }
  if (entry.name.empty() || entry.path.empty()) Fail(place, "\"name\" and \"path\" are needed");
  return entry;
}

}  // namespace

std::vector<SceneEntry> ReadSceneSet(const std::string& path) {
  const std::string text = ReadFile(path);
  const Json root = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (root.is_discarded()) Fail(path, "not valid JSON");
  if (!root.is_object() || root.value("rasterproof_scene_set", 0) != 1 ||
      !root.contains("scenes") || !root["scenes"].is_array() || root.size() != 2) {
    Fail(path, R"(expected {"rasterproof_scene_set": 1, "scenes": [...]})");
  }
  std::vector<SceneEntry> entries;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const Json& object : root["scenes"]) {
    entries.push_back(
        ReadEntry(object, folder, path + ": scenes[" + std::to_string(entries.size()) + "]"));
  }
  return entries;
}

}  // namespace rasterproof::io
