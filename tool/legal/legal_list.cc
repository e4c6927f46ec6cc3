#include "tool/legal/legal_list.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/output.h"
#include "tool/known_failures.h"

namespace rasterproof::tool {
namespace {

constexpr std::array<std::string_view, 2> kLegalListKeys{"rasterproof_legal_list", "drawings"};
constexpr std::array<std::string_view, 10> kDrawingKeys{
    "name",   "scene",      "image",   "profile", "expected",
    "reason", "background", "facings", "owner",   "until"};
constexpr std::array<std::string_view, 2> kExpected{"legal", "illegal"};

// A preset's name stays; a file of that name in the folder is meant by "./NAME".
std::string ProfileFrom(const io::JsonValue& value, const std::filesystem::path& folder) {
  const std::string text(value.RequireString());
  return text.ends_with(".json") ? (folder / text).string() : text;
}

void ReadExpected(const io::JsonValue& object, ListedDrawing& listed) {
  if (const auto expected = object.Find("expected"))
    listed.is_legal = io::IndexOf(*expected, kExpected) == 0;
  for (const std::string_view key : {"reason", "owner", "until"}) {
    if (listed.is_legal && object.Find(key)) {
      throw object.Get(key).Error("is only for a drawing expected to be illegal",
                                  "write \"expected\": \"illegal\", or leave it out");
    }
  }
  if (listed.is_legal) return;
  listed.reason = object.Get("reason").RequireName();
  if (listed.reason.empty())
    throw object.Get("reason").Error("is empty", "say why the drawing is not legal");
  if (!object.Find("owner") && !object.Find("until")) return;
  listed.owner = object.Get("owner").RequireName();
  if (listed.owner.empty())
    throw object.Get("owner").Error("names nobody", "name the drawing's owner");
  listed.until = ReadDay(object.Get("until"));
}

ListedDrawing ReadDrawingEntry(const io::JsonValue& object, const std::filesystem::path& folder,
                               const LegalOptions& base) {
  object.RequireObject(kDrawingKeys);
  ListedDrawing listed{.place = object.Place(), .name = object.Get("name").RequireName()};
  listed.options = base;
  listed.options.scene.path = (folder / object.Get("scene").RequireString()).string();
  io::ReadIfThere(object, "profile", listed.options.profile,
                  [&](const io::JsonValue& value) { return ProfileFrom(value, folder); });
  io::ReadIfThere(object, "background", listed.options.background,
                  [](const io::JsonValue& value) { return std::string(value.RequireString()); });
  if (const auto image = object.Find("image")) {
    listed.options.image = (folder / image->RequireString()).string();
    listed.options.subject.clear();
    io::ReadIfThere(object, "facings", listed.options.facings, [&](const io::JsonValue& value) {
      return (folder / value.RequireString()).string();
    });
  } else if (const auto facings = object.Find("facings")) {
    throw facings->Error("is only for an image, and none is given",
                         "give \"image\", or leave it out");
  } else if (base.subject.empty()) {
    throw object.Error("has no image, and no subject draws",
                       "give it \"image\", or name --subject, --plugin or --exec");
  }
  if (listed.options.profile.empty() && listed.options.subject.empty()) {
    throw object.Error("has no profile", "give it \"profile\", or all of them --profile");
  }
  ReadExpected(object, listed);
  return listed;
}

}  // namespace

std::vector<ListedDrawing> ReadLegalList(const std::string& path, const LegalOptions& base) {
  const std::string text = io::ReadFile(path);
  const io::JsonDocument document(text, path == "-" ? "standard input" : path);
  io::JsonValue list = document.root();
  if (list.kind() == io::JsonKind::kObject) {
    list.RequireObject(kLegalListKeys);
    list.Get("rasterproof_legal_list").RequireInteger(1, 1);  // the version
    list = document.root().Get("drawings");
  }
  std::vector<ListedDrawing> drawings;
  std::vector<std::string> names;
  for (const io::JsonValue item : list.RequireArray()) {
    ListedDrawing listed = ReadDrawingEntry(item, std::filesystem::path(path).parent_path(), base);
    if (std::ranges::find(names, listed.name) != names.end()) {
      throw item.Get("name").Error(Quoted(listed.name) + " is used twice",
                                   "give every drawing its own name");
    }
    names.push_back(listed.name);
    drawings.push_back(std::move(listed));
  }
  if (drawings.empty()) throw list.Error("is empty", "list a drawing");
  return drawings;
}

}  // namespace rasterproof::tool
