#include "web/engine/open.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/quoted.h"
#include "core/suggestion.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/profile_json.h"

namespace rasterproof::web {
namespace {

using io::JsonValue;

constexpr std::array<std::pair<CoverageKind, std::string_view>, 5> kCoverages{
    {{CoverageKind::kFacingCounts, "facing-counts"},
     {CoverageKind::kCounts, "counts"},
     {CoverageKind::kMask, "mask"},
     {CoverageKind::kPrimitiveIds, "primitive-id"},
     {CoverageKind::kFragments, "fragments"}}};
constexpr std::array<std::pair<Precision, std::string_view>, 2> kInputs{
    {{Precision::kFloat32, "float32"}, {Precision::kFloat64, "float64"}}};
constexpr std::array<std::pair<Visible, std::string_view>, 2> kOrders{
    {{Visible::kLastDrawn, "last-drawn"}, {Visible::kFirstDrawn, "first-drawn"}}};
constexpr std::array<std::pair<bool SubjectInfo::*, std::string_view>, 4> kTakes{
    {{&SubjectInfo::takes_window, "window"},
     {&SubjectInfo::takes_clip, "clip"},
     {&SubjectInfo::takes_culling, "culling"},
     {&SubjectInfo::takes_scissor, "scissor"}}};
constexpr std::array<std::pair<bool FragmentInfo::*, std::string_view>, 3> kShows{
    {{&FragmentInfo::shows_centroids, "centroids"},
     {&FragmentInfo::shows_values, "values"},
     {&FragmentInfo::shows_derivatives, "derivatives"}}};

void TakeSubject(const JsonValue& object, SubjectInfo& info) {
  constexpr std::array<std::string_view, 6> kKeys{"name",    "input", "coverage",
                                                  "visible", "shows", "takes"};
  object.RequireObject(kKeys);
  io::ReadIfThere(object, "name", info.name,
                  [](const JsonValue& value) { return value.RequireName(); });
  io::ReadIfThere(object, "input", info.input, [](const JsonValue& value) {
    return io::FromName(value, io::Names<Precision>(kInputs));
  });
  io::ReadIfThere(object, "coverage", info.coverage, [](const JsonValue& value) {
    return io::FromName(value, io::Names<CoverageKind>(kCoverages));
  });
  io::ReadIfThere(object, "visible", info.fragments.visible, [](const JsonValue& value) {
    return io::FromName(value, io::Names<Visible>(kOrders));
  });
  if (const std::optional<JsonValue> shows = object.Find("shows")) {
    for (const JsonValue word : shows->RequireArray())
      info.fragments.*io::FromName(word, io::Names<bool FragmentInfo::*>(kShows)) = true;
    if (info.coverage != CoverageKind::kFragments)
      throw shows->Error("is of fragments", "give the coverage \"fragments\", or leave it out");
  }
  const std::optional<JsonValue> takes = object.Find("takes");
  if (!takes) return;
  for (const auto& [member, name] : kTakes) info.*member = false;
  for (const JsonValue word : takes->RequireArray()) {
    info.*io::FromName(word, io::Names<bool SubjectInfo::*>(kTakes)) = true;
  }
  if (info.takes_window || info.takes_clip) return;
  throw takes->Error("names neither window nor clip space", "name one");
}

// What a program on a pipe is, without a word of its own.
SubjectInfo PlainInfo() {
  SubjectInfo info;
  info.name = "subject";
  info.takes_culling = info.takes_scissor = info.takes_tiles = info.takes_float_modes = false;
  info.coverage = CoverageKind::kCounts;
  info.list_length = kListLengthOfPrograms;
  return info;
}

const props::Property& PropertyOf(const JsonValue& name) {
  if (const props::Property* found = props::FindProperty(name.RequireString())) return *found;
  std::vector<std::string_view> names;
  for (const props::Property& property : props::Catalog()) names.push_back(property.name);
  throw name.Error("there is no property " + Quoted(name.text()),
                   Suggestion(name.text(), names) + "give a name of the catalogue");
}

}  // namespace

Opened OpenedFrom(std::string_view json) {
  const io::JsonDocument document(json, "check");
  Opened opened = OpenedFrom(document.root());
  opened.json = json;
  return opened;
}

Opened OpenedFrom(const JsonValue& root) {
  constexpr std::array<std::string_view, 8> kKeys{"subject", "profile", "properties", "seed",
                                                  "cases",   "shrink",  "infer",      "causes"};
  root.RequireObject(kKeys);
  Opened opened;
  opened.info = PlainInfo();
  if (const auto subject = root.Find("subject")) TakeSubject(*subject, opened.info);
  if (const auto profile = root.Find("profile")) opened.info.profile = ProfileFromJson(*profile);
  const auto integer = [](const JsonValue& value) {
    return static_cast<std::uint64_t>(
        value.RequireInteger(0, std::numeric_limits<std::int64_t>::max()));
  };
  io::ReadIfThere(root, "seed", opened.campaign.seed, integer);
  io::ReadIfThere(root, "cases", opened.campaign.cases, integer);
  io::ReadIfThere(root, "shrink", opened.campaign.shrink_budget, integer);
  io::ReadIfThere(root, "infer", opened.infers, io::Boolean);
  io::ReadIfThere(root, "causes", opened.explains, io::Boolean);
  const auto properties = root.Find("properties");
  opened.is_whole_catalogue = !properties;
  if (!properties) {
    for (const props::Property& property : props::Catalog()) opened.properties.push_back(&property);
  } else {
    for (const JsonValue name : properties->RequireArray())
      opened.properties.push_back(&PropertyOf(name));
  }
  return opened;
}

}  // namespace rasterproof::web
